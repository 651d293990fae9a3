import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { Command } from '../src/link/socket';
import type { Desk } from '../src/panel/parts/part';
import { entry } from '../src/panel/target/entry';
import { frameOf } from './panel-frames';
import { small, useSmallPage } from './small-page';
import { FEET } from './worksite';

beforeEach(useSmallPage);

afterEach(() => {
  vi.unstubAllGlobals();
});

/** The fields of a target, which show the tip's pose. */
function fields() {
  const sent: Command[] = [];
  const said: string[] = [];
  const desk = {
    welcome: { modes: [] },
    send: (command: Command) => sent.push(command),
    say: (text: string) => said.push(text),
  };
  const target = entry(desk as unknown as Desk);
  const { all } = small(target.element);
  const actual = { position: [-22, 0, -12], attitude: [0, 0, 0] };
  target.set(frameOf({ mode: 'ORB UNL', display: { actual, aim: null } }), FEET);
  return {
    ...{ target, sent, said },
    type(name: string, text: string) {
      const field = all.find((each) => each.getAttribute('aria-label') === `Target ${name}`);
      if (!field) throw new Error(name);
      field.value = text;
      field.dispatch('input', {});
      return field;
    },
  };
}

test('keyed-in lengths are sent in metres, and angles in radians', () => {
  const { target, sent, said, type } = fields();
  type('X', '−100');
  type('pitch', '90');
  expect(target.keyIn()).toBe(true);
  expect(said).toEqual([]);
  expect(sent).toHaveLength(1);
  const [command] = sent;
  if (command?.type !== 'set_target') throw new Error(command?.type);
  expect(command.position[0]).toBeCloseTo(-2.54);
  expect(command.attitude[0]).toBeCloseTo(Math.PI / 2);
});

test.each([
  ['Y', 'far'],
  ['roll', ''],
])('a target whose %s is “%s” is rejected, and the field is marked until it is corrected', (name, text) => {
  const { target, sent, said, type } = fields();
  const field = type(name, text);
  expect(target.keyIn()).toBe(false);
  expect(sent).toEqual([]);
  expect(said).toHaveLength(1);
  expect(said[0]).toContain(text);
  expect(field.getAttribute('aria-invalid')).toBe('true');
  type(name, '1');
  expect(field.getAttribute('aria-invalid')).toBeNull();
  expect(target.keyIn()).toBe(true);
});

import { expect, test } from 'vitest';
import { actionOf } from '../src/replay/keys';
import { player } from './recording-player';

const none = () => {};
/** Key actions that do nothing. */
const NOTHING = {
  event: none,
  desk: none,
  camera: none,
  stepCamera: none,
  otherMonitor: none,
  plane: none,
  bending: none,
  matrix: none,
  split: none,
  asFlown: none,
  zoom: none,
  close: none,
};

test('keys play, seek and step; an unassigned key does nothing', async () => {
  const { player: made } = await player();
  const press = (code: string, shiftKey = false) => actionOf(made, NOTHING, { code, shiftKey })?.();
  press('Space');
  expect(made.playing).toBe(true);
  press('End');
  expect(made.position).toBe(20);
  press('ArrowLeft');
  expect(made.position).toBe(19);
  press('ArrowLeft', true);
  expect(made.position).toBeCloseTo(18.98);
  press('Home');
  expect(made.position).toBe(0.02);
  expect(actionOf(made, NOTHING, { code: 'KeyW', shiftKey: false })).toBeUndefined();
});

test('the key A restores the cameras as flown; the keys plus and minus zoom', async () => {
  const { player: made } = await player();
  const done: string[] = [];
  const keys = {
    ...NOTHING,
    asFlown: () => done.push('as flown'),
    zoom: (way: number) => done.push(`zoom ${way}`),
  };
  for (const code of ['KeyA', 'Equal', 'Minus']) actionOf(made, keys, { code, shiftKey: false })?.();
  expect(done).toEqual(['as flown', 'zoom 1', 'zoom -1']);
});

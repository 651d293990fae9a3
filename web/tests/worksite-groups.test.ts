/** Groups of the desk that show the worksite: clearance, conditions, payloads, end effector, and the task phases. */

import { afterEach, beforeEach, describe, expect, it, test, vi } from 'vitest';
import { KEYS } from '../src/input/active-device';
import type { Cargo, EffectorSwitch, Near, Work, WorkInfo } from '../src/link/protocol';
import type { Command } from '../src/link/socket';
import { clearanceGroup } from '../src/panel/clearance/clearance';
import { conditionsGroup } from '../src/panel/clearance/conditions';
import { cargoGroup } from '../src/panel/effector/cargo';
import { effectorGroup } from '../src/panel/effector/effector';
import type { Desk, Part, View } from '../src/panel/parts/part';
import { initialise } from '../src/panel/rail/initialise';
import { frameOf } from './panel-frames';
import { type SmallElement, small, useSmallPage } from './small-page';
import { condition, FEET, near, work } from './worksite';

beforeEach(useSmallPage);

afterEach(() => {
  vi.unstubAllGlobals();
});

/** A desk whose commands are stored. */
function desk(parts: Partial<WorkInfo> = {}) {
  const sent: Command[] = [];
  const info = {
    ...{ hand: 'snares', cargo: ['payload', 'free flyer'], seats: [{ name: 'bay', title: 'Cargo bay' }] },
    ...{ caution: 0.6, warning: 0.15, parts: [], ...parts },
  };
  const welcome = { work: info, joints: [], payloads: [] };
  return { desk: { welcome, send: (command: Command) => sent.push(command) } as unknown as Desk, sent };
}

/** Shows a worksite in a group of the desk. */
function show(group: Part, shown: Work): SmallElement {
  const frame = frameOf({ work: shown, time_s: 1, ways_out: [], dynamics: null, motions: [] });
  const view = { frame, units: FEET, controllers: { names: KEYS } } as unknown as View;
  group.bars?.(view);
  group.values?.(view);
  return small(group.element);
}

describe('the clearance', () => {
  const shown = (parts: Partial<Near>) =>
    show(clearanceGroup(desk().desk), work({ nearest: near(parts) })).querySelector('p.closing')?.textContent;

  it('that decreases has its rate and the time to contact', () => {
    expect(shown({ clearance: 0.38, closing: 0.021 })).toBe('closing 0.8 in/scontact in 18 s');
  });

  it('that increases has only its rate', () => {
    expect(shown({ clearance: 4.1, closing: -0.021 })).toBe('opening 0.8 in/s');
  });

  it('has the colour of its level', () => {
    const classes = (clearance_level: Work['clearance_level']) =>
      show(clearanceGroup(desk().desk), work({ nearest: near({}), clearance_level })).classes;
    expect(classes('info')).toEqual(['group', 'clearance']);
    expect(classes('caution')).toContain('caution');
    expect(classes('warning')).toContain('warning');
  });
});

test('the button of the separating plane is pressed while the pictures show the plane', () => {
  const act = vi.fn();
  const group = clearanceGroup({ ...desk().desk, act });
  const key = small(group.element).button('Plane');
  key?.click();
  expect(act.mock.calls).toEqual([['plane']]);
  group.setPlane(true);
  expect(key?.getAttribute('aria-pressed')).toBe('true');
  group.setPlane(false);
  expect(key?.getAttribute('aria-pressed')).toBe('false');
});

test('conditions keep their order; their title has the first failure, then the next action', () => {
  const group = conditionsGroup();
  const objective = { action: 'capture', text: 'capture payload' } as const;
  const shown = (...margins: number[]) => {
    const conditions = ['off axis', 'distance', 'roll'].map((name, i) =>
      condition({ name, margin: margins[i] ?? 0, words: `${name} wrong` }),
    );
    const element = show(group, work({ objective, conditions }));
    const names = element.all
      .filter(({ classes }) => classes.includes('name'))
      .map((name) => name.textContent);
    return [element.querySelector('h2')?.textContent, names.filter((name) => name !== '').join()];
  };
  const order = 'off axis,distance,roll';
  expect(shown(-1, 1, 1)).toEqual(['capture payloadoff axis wrong', order]);
  expect(shown(1, 1, -1)).toEqual(['capture payloadroll wrong', order]);
  expect(shown(1, 1, 1)).toEqual(['capture payloadall met: capture, hold G', order]);
});

test('a payload in a berth has the name of the berth, and a free payload its speed', () => {
  const payload = { held: false, velocity: [0, 0, 0] };
  const cargo = [
    { ...payload, name: 'payload', seat: 'bay' },
    { ...payload, name: 'free flyer', seat: '', velocity: [0.012, 0, 0] },
  ] as unknown as readonly Cargo[];
  const rows = show(cargoGroup(desk().desk), work({ cargo, task: 1 })).all.filter(({ tag }) => tag === 'tr');
  expect(rows.map((row) => row.textContent)).toEqual(['payloadCargo bay', 'free flyerfree0.5 in/s']);
});

describe('a key of the end effector', () => {
  /** Presses the key that closes the end effector for 1 s. */
  const pressed = (hand: WorkInfo['hand'], put: EffectorSwitch) => {
    const { desk: own, sent } = desk({ hand });
    const group = effectorGroup(own);
    const still = {
      opening: 0.6,
      spacing: 0.3,
      carriage: null,
      flags: [],
      mode: 'auto',
      rigid: 'off',
    } as const;
    show(group, work({ hand: { ...still, switch: put } }));
    group.grip({ name: 'grip', grip: 'close', down: true, at: 1000 });
    group.grip({ name: 'grip', grip: 'close', down: false, at: 2000 });
    return sent;
  };
  const effector = (put: EffectorSwitch) => ({ type: 'effector', switch: put });

  it('stops the moving prong at once, and does no more', () => {
    expect(pressed('prong', 'close')).toEqual([effector('stop')]);
  });

  it('stops the prong that moves in the other direction, and reverses it after a hold', () => {
    expect(pressed('prong', 'open')).toEqual([effector('stop'), effector('close')]);
  });

  it('closes the prong at rest, and the snares, after a hold', () => {
    expect(pressed('prong', 'stop')).toEqual([effector('close')]);
    expect(pressed('snares', 'open')).toEqual([effector('close')]);
  });
});

test('a task phase chosen from the list is initialised, and the list closes', () => {
  const { desk: own, sent } = desk({ parts: ['full problem', 'extraction'] });
  const element = small(initialise(own).element);
  const list = element.querySelector('div.choices');
  expect(list?.hidden).toBe(true);
  element.button('Initialise')?.click();
  expect(list?.hidden).toBe(false);
  element.button('extraction')?.click();
  expect(sent).toEqual([{ type: 'initialise', part: 'extraction' }]);
  expect(list?.hidden).toBe(true);
});

test('a worksite without task phases has no list of them', () => {
  expect(small(initialise(desk().desk).element).hidden).toBe(true);
});

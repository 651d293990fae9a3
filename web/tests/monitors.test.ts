import { afterEach, beforeEach, describe, expect, it, test, vi } from 'vitest';
import { Monitors } from '../src/cameras/monitors';
import type { Camera } from '../src/link/protocol';
import { bay } from './camera-values';
import { small, useSmallPage } from './small-page';

beforeEach(useSmallPage);

afterEach(() => {
  vi.unstubAllGlobals();
});

const NAMES = [...'ABCDEFGHIJKL'];
const CAMERAS: readonly Camera[] = NAMES.map((name) => ({ ...bay, name }));
const [A, B, C] = CAMERAS as [Camera, Camera, Camera, ...Camera[]];

/** Two monitors in a scenario with cameras A to L. Both monitors show camera A at first. */
function made() {
  const changed = vi.fn();
  const chosen = vi.fn();
  const monitors = new Monitors(CAMERAS, A, {
    ...{ changed, chosen, turns: true },
    round() {},
    orbited() {},
  });
  return {
    ...{ monitors, changed, chosen },
    /** Cameras of each monitor, and the position of the selected picture among all pictures. */
    state: () => {
      const pictures = monitors.both.flatMap((monitor) => monitor.pictures);
      const selected = pictures.indexOf(monitors.hand.picture);
      return `${monitors.shown.map((names) => names.join('')).join(' ')} ${selected}`;
    },
  };
}

test('a monitor has the key 1972 only if something computes this look', () => {
  const listener = { turns: true, changed() {}, chosen() {}, round() {}, orbited() {} };
  const seventies = vi.fn();
  const keys = (monitors: Monitors) =>
    monitors.both.map(({ element }) => small(element).textContent.split('1972').length - 1);
  expect(keys(new Monitors(CAMERAS, A, listener))).toEqual([0, 0]);
  expect(keys(new Monitors(CAMERAS, A, { ...listener, seventies }))).toEqual([1, 1]);
});

test('at first, MON 1 is selected and no camera is chosen', () => {
  const { monitors, state } = made();
  expect(state()).toBe('A A 0');
  expect(monitors.chosen).toBe(false);
});

test('a camera is put on the selected monitor', () => {
  const { monitors, state, changed, chosen } = made();
  monitors.choose(B);
  monitors.take(1);
  monitors.choose(C);
  expect(state()).toBe('B C 1');
  expect(monitors.camera).toBe(C);
  expect(monitors.chosen).toBe(true);
  expect([changed.mock.calls.length, chosen.mock.calls.length]).toEqual([2, 2]);
});

describe('a digit', () => {
  it.each([
    ['pressed once', [[0, 1]], 'B'],
    [
      'pressed again within 0.7 s',
      [
        [0, 1],
        [699, 1],
      ],
      'L',
    ],
    [
      'pressed again after 0.7 s',
      [
        [0, 1],
        [700, 1],
      ],
      'B',
    ],
    [
      'pressed three times',
      [
        [0, 1],
        [300, 1],
        [600, 1],
      ],
      'B',
    ],
    [
      'pressed four times',
      [
        [0, 1],
        [200, 1],
        [400, 1],
        [600, 1],
      ],
      'L',
    ],
    [
      'pressed after another digit',
      [
        [0, 0],
        [300, 1],
      ],
      'B',
    ],
    [
      'pressed again after another digit',
      [
        [0, 1],
        [200, 0],
        [400, 1],
      ],
      'B',
    ],
    [
      'pressed again without a camera ten places later',
      [
        [0, 2],
        [300, 2],
      ],
      'C',
    ],
  ] as const)('%s selects a camera', (_, presses, name) => {
    const { monitors } = made();
    for (const [now, index] of presses) monitors.chooseDigit(index, 5000 + now);
    expect(monitors.camera.name).toBe(name);
  });

  it('without a camera changes nothing', () => {
    const monitors = new Monitors([A, B], A, {
      changed: () => expect.fail(),
      chosen: () => expect.fail(),
      round() {},
      orbited() {},
      turns: true,
    });
    monitors.chooseDigit(2, 0);
    expect(monitors.shown).toEqual([['A'], ['A']]);
  });
});

test('a step forward from the last camera leads to the first, and a step back to the last', () => {
  const { monitors } = made();
  const step = (by: number) => {
    monitors.step(by);
    return monitors.camera.name;
  };
  expect([step(1), step(1), step(-1), step(-1), step(-1)]).toEqual(['B', 'C', 'B', 'A', 'L']);
  expect(monitors.chosen).toBe(true);
  for (let i = 0; i < NAMES.length; i += 1) step(1);
  expect(monitors.camera.name).toBe('L');
});

describe('a monitor that is split', () => {
  it('shows its camera in both halves and selects the right one', () => {
    const { monitors, state } = made();
    monitors.toggleSplit();
    expect(state()).toBe('AA A 1');
    monitors.choose(B);
    expect(state()).toBe('AB A 1');
  });

  it('keeps the selected half when the split ends', () => {
    const { monitors, state } = made();
    monitors.toggleSplit();
    monitors.choose(B);
    monitors.toggleSplit();
    expect(state()).toBe('B A 0');
  });

  it('keeps the left half if the left half is selected', () => {
    const { monitors, state } = made();
    monitors.toggleSplit();
    monitors.choose(B);
    monitors.take(0, 0);
    monitors.toggleSplit();
    expect(state()).toBe('A A 0');
  });

  it('counts as two pictures when pictures are selected in turn', () => {
    const { monitors, state } = made();
    monitors.toggleSplit();
    monitors.take(0, 0);
    const round = [];
    for (let i = 0; i < 4; i += 1) {
      round.push(state().slice(-1));
      monitors.takeOther();
    }
    expect(round).toEqual(['0', '1', '2', '0']);
  });
});

test('another page or a recording puts one or two cameras on a monitor', () => {
  const { monitors, state, changed } = made();
  monitors.show(1, ['B', 'C']);
  expect(state()).toBe('A BC 0');
  monitors.show(1, ['D']);
  expect(state()).toBe('A D 0');
  expect(monitors.chosen).toBe(true);
  expect(changed).toHaveBeenCalledTimes(2);
});

test('a request for the cameras that a monitor already shows changes nothing', () => {
  const { monitors, changed } = made();
  monitors.show(0, ['A']);
  expect(changed).not.toHaveBeenCalled();
  expect(monitors.chosen).toBe(false);
});

test('names without a camera change no picture', () => {
  const { monitors, state } = made();
  monitors.show(0, ['none of them']);
  expect(state()).toBe('A A 0');
});

test('a run begins with one camera on each monitor', () => {
  const { monitors, state, changed, chosen } = made();
  monitors.begin([B, C]);
  expect(state()).toBe('B C 0');
  expect(monitors.chosen).toBe(true);
  expect([changed.mock.calls.length, chosen.mock.calls.length]).toEqual([1, 0]);
});

test('only the selected monitor is marked', () => {
  const { monitors } = made();
  const marked = () => monitors.both.map(({ element }) => small(element).classes.includes('in-hand'));
  expect(marked()).toEqual([true, false]);
  monitors.takeOther();
  expect(marked()).toEqual([false, true]);
});

test('a key of the selector puts its camera on its own monitor', () => {
  const { monitors, state } = made();
  const key = small(monitors.both[1].element).all.find(
    ({ tag, textContent }) => tag === 'button' && textContent === 'C',
  );
  key?.click();
  expect(state()).toBe('A C 1');
});

test('the low speed of the drives is shown on both monitors', () => {
  const { monitors } = made();
  const pressed = () =>
    monitors.both.map(({ element }) =>
      small(element).querySelector('button.slow')?.getAttribute('aria-pressed'),
    );
  monitors.toggleSlow();
  expect([monitors.slow, ...pressed()]).toEqual([true, 'true', 'true']);
  monitors.toggleSlow();
  expect([monitors.slow, ...pressed()]).toEqual([false, 'false', 'false']);
});

import { beforeEach, expect, test, vi } from 'vitest';
import { KEYS } from '../src/input/active-device';
import { Device } from '../src/input/device';
import { type HoldButton, holdButton } from '../src/panel/parts/hold-button';
import { NO_AXES, reading } from './gamepads';
import { small, useSmallPage } from './small-page';

/** Time for which the button must be held, and time for which the page stands still after a press [ms]. */
const [HELD_MS, STALL_MS] = [1000, 2000];

let around: EventTarget;
let acted: number;
let now: number;

beforeEach(() => {
  useSmallPage();
  around = new EventTarget();
  vi.stubGlobal('window', around);
  Object.assign(document, { addEventListener() {}, removeEventListener() {} });
  vi.spyOn(performance, 'now').mockImplementation(() => now);
  [acted, now] = [0, 0];
});

function made() {
  return holdButton('Release', 'open', HELD_MS / 1000, () => {
    acted += 1;
  });
}

/** An event at the time `at` [ms], which the page may handle later. */
function event(type: string, at: number, values: object = {}): Event {
  const made = new Event(type, { cancelable: true });
  Object.defineProperty(made, 'timeStamp', { value: at });
  return Object.assign(made, { key: 'Enter', pointerId: 1, pointerType: 'mouse' }, values);
}

/** Ways to hold a button: each presses it at 0, and tells it after a stall of a release at a time [ms]. */
const WAYS: Readonly<Record<string, (button: HoldButton) => (released: number) => void>> = {
  pointer({ element }) {
    small(element).dispatch('pointerdown', event('pointerdown', 0));
    return (released) => {
      around.dispatchEvent(event('pointerup', released));
      small(element).dispatch('pointerleave', event('pointerleave', released));
    };
  },
  Enter({ element }) {
    small(element).dispatch('keydown', event('keydown', 0));
    return (released) => small(element).dispatch('keyup', event('keyup', released));
  },
  'button of a pad'(button) {
    const device = new Device('pad', (action) => {
      if (action.name === 'grip') button[action.down ? 'press' : 'lift'](action.at);
    });
    const read = (pressed: boolean, at: number) =>
      device.read(reading(NO_AXES, pressed ? { 9: 1, 3: 1 } : {}), at);
    for (const pressed of [{}, { 9: 1 }]) device.read(reading(NO_AXES, pressed), 0);
    read(true, 0);
    return (released) => {
      for (let at = 0; at < released; at += 20) read(true, at);
      read(false, STALL_MS);
    };
  },
};

/** Holds a new button in this way from 0 to `released` [ms], while the page stands still until STALL_MS. */
function hold(way: string, released: number): void {
  const button = made();
  const release = WAYS[way]?.(button);
  now = STALL_MS;
  button.tick(KEYS); // the page may draw before it handles the release
  release?.(released);
  button.tick(KEYS);
}

test.each(Object.keys(WAYS))('a hold by %s that ended during a stall of the page does not act', (way) => {
  hold(way, 300);
  expect(acted).toBe(0);
});

test.each(Object.keys(WAYS))(
  'a hold by %s that was long enough acts even after a stall of the page',
  (way) => {
    hold(way, HELD_MS + 100);
    expect(acted).toBe(1);
  },
);

import { expect, test } from 'vitest';
import { isZero } from '../src/input/deflection';
import { Pads } from '../src/input/pads';
import { NO_AXES, plugged } from './gamepads';

const TICK_MS = 20;

/** A device with six axes, and the time at which its readings are taken. */
function device(standard: boolean, axes: readonly number[]) {
  const world = plugged({ id: 'Device', standard, axes: [...axes] });
  const pads = new Pads(() => {});
  let now = 0;
  return {
    pads,
    /** Sets the axes for a time [ms]; returns the last deflections, and whether all deflections were zero. */
    hold(time: number, ...values: number[]) {
      world.axes(0, ...values);
      let still = true;
      let last: readonly number[] = [];
      for (const end = now + time; now < end; now += TICK_MS) {
        last = pads.poll(now);
        still &&= isZero(last);
      }
      return { last, still };
    },
  };
}

const REST = [0, 0, 0, 0, 0, 0];
const PULLS = [0.05, 0.1, 0.3, 0.6, 1].flatMap((value) => [value, value]);

test('a trigger that rests at −1 never moves the arm, wherever its first reading is', () => {
  for (const standard of [true, false]) {
    for (const first of standard ? [-1, -0.9] : [-1, 0]) {
      const { hold } = device(standard, [0, 0, first, 0, 0, 0]);
      hold(2000, 0, 0, first, 0, 0, 0);
      // Pulled slowly and fast through its middle, held half pulled for a moment, and released.
      for (const pause of [20, 100, 400]) {
        for (const value of [-0.99, -0.5, -0.02, 0, 0.03, 0.5, 1, 0.4, 0, -0.6, -1])
          expect(hold(pause, 0, 0, value, 0, 0, 0).still).toBe(true);
        expect(hold(10_000, 0, 0, -1, 0, 0, 0).still).toBe(true);
      }
    }
  }
});

test('the other axes of a device act while one axis rests at −1', () => {
  const { hold, pads } = device(true, [0, 0, -1, 0, 0, 0]);
  hold(3000, 0, 0, -1, 0, 0, 0);
  expect(pads.devices[0]).toMatchObject({ state: 'waiting', resting: true });
  expect(hold(100, 0, -1, -1, 0, 0, 0).last[0]).toBe(1);
});

test('a stick of a joystick acts after it was moved and has rested at zero', () => {
  const { hold } = device(false, REST);
  hold(3000, ...REST);
  for (const value of PULLS) expect(hold(20, 0, -value, 0, 0, 0, 0).still).toBe(true);
  expect(hold(1000, ...REST).still).toBe(true);
  expect(hold(20, 0, -1, 0, 0, 0, 0).still).toBe(true); // it has not rested for long enough
  hold(2000, ...REST);
  expect(hold(20, 0, -1, 0, 0, 0, 0).last[0]).toBe(1);
  expect(hold(20, 1, -1, 0, 0, 0, 0).last.slice(0, 2)).toEqual([1, 0]); // the other axis has never moved
});

test('full deflection that a hand holds stays believed', () => {
  for (const standard of [true, false]) {
    const { hold } = device(standard, NO_AXES);
    hold(100, 0, -0.5, 0, 0);
    hold(2000, ...NO_AXES);
    expect(hold(60_000, 0, -1, 0, 0).last[0]).toBe(1);
  }
});

import { expect, test, vi } from 'vitest';
import { isZero, sum, ZERO } from '../src/input/deflection';
import { deflection, Pad, shape } from '../src/input/gamepad';
import { ramp } from '../src/input/keyboard';
import { ACTION_KEYS, type Action, AXIS_KEYS, GRIP_KEYS } from '../src/input/keymap';
import { routed } from '../src/input/sticks';

function pad(axes: number[], pressed: Record<number, number> = {}): Gamepad {
  const buttons = Array.from({ length: 16 }, (_, i) => ({
    pressed: (pressed[i] ?? 0) > 0.5,
    touched: false,
    value: pressed[i] ?? 0,
  }));
  return { axes, buttons } as unknown as Gamepad;
}

test('a key reaches full deflection in 0.35 s and zero in 0.15 s', () => {
  expect(ramp(0, 1, 0.175)).toBeCloseTo(0.5);
  expect(ramp(0, 1, 0.36)).toBe(1);
  expect(ramp(1, 0, 0.075)).toBeCloseTo(0.5);
  expect(ramp(-1, 0, 0.16)).toBe(0);
});

test('an axis changes sides through zero', () => {
  expect(ramp(0.1, -1, 0.1)).toBe(0);
  expect(ramp(0, -1, 0.035)).toBeCloseTo(-0.1);
});

test('a pad axis has a deadband of 8 % and reaches full deflection', () => {
  expect(shape(0.08)).toBe(0);
  expect(shape(-0.05)).toBe(-0);
  expect(shape(1)).toBe(1);
  expect(shape(-1)).toBe(-1);
});

test('expo makes the middle finer, the same on both sides', () => {
  expect(shape(0.54)).toBeCloseTo(0.7 * 0.5 + 0.3 * 0.125);
  expect(shape(-0.54)).toBeCloseTo(-shape(0.54));
});

test('a pad at rest is at zero, signs included', () => {
  expect(deflection(pad([0, 0, 0, 0])).every((value) => Object.is(value, 0))).toBe(true);
  expect(isZero(deflection(pad([0.05, -0.05, 0.07, 0])))).toBe(true);
});

test('the left stick translates, away is +X; the triggers lift and lower', () => {
  expect(deflection(pad([0, -1, 0, 0]))).toEqual([1, 0, 0, 0, 0, 0, 0]);
  expect(deflection(pad([1, 0, 0, 0]))).toEqual([0, 1, 0, 0, 0, 0, 0]);
  expect(deflection(pad([0, 0, 0, 0], { 6: 1 }))).toEqual([0, 0, -1, 0, 0, 0, 0]);
  expect(deflection(pad([0, 0, 0, 0], { 7: 1 }))).toEqual([0, 0, 1, 0, 0, 0, 0]);
});

test('the right stick pitches and yaws; the bumpers roll', () => {
  expect(deflection(pad([0, 0, 0, -1]))).toEqual([0, 0, 0, 0, 1, 0, 0]);
  expect(deflection(pad([0, 0, 1, 0]))).toEqual([0, 0, 0, 0, 0, 1, 0]);
  expect(deflection(pad([0, 0, 0, 0], { 4: 1 }))).toEqual([0, 0, 0, -1, 0, 0, 0]);
});

test('both devices together stay within full deflection', () => {
  expect(sum([0.8, -0.5, 0, 0, 0, 0, 0], [0.8, -0.2, 0, 0, 0, 0, 0])).toEqual([1, -0.7, 0, 0, 0, 0, 0]);
  expect(isZero(sum(ZERO, ZERO))).toBe(true);
});

test('every stick axis has a key for either side, and no key two meanings', () => {
  const sides = new Set([...AXIS_KEYS.values()].map(({ axis, sign }) => `${axis}${sign}`));
  expect(sides.size).toBe(14);
  const all = [...AXIS_KEYS.keys(), ...ACTION_KEYS.keys(), ...GRIP_KEYS.keys()];
  expect(all.length).toBe(new Set(all).size);
});

test('Menu and the cross put the telescope; the cross alone does not', () => {
  expect(deflection(pad([0, 0, 0, 0], { 9: 1, 12: 1 }))).toEqual([0, 0, 0, 0, 0, 0, 1]);
  expect(deflection(pad([0, 0, 0, 0], { 9: 1, 13: 1 }))).toEqual([0, 0, 0, 0, 0, 0, -1]);
  expect(isZero(deflection(pad([0, 0, 0, 0], { 12: 1 })))).toBe(true);
});

/** A pad that a test presses, and what it did: an action's name, a grip with + and -. */
function pressed() {
  let buttons: Record<number, number> = {};
  let there = true;
  const acted: string[] = [];
  const standard = () => ({ ...pad([0, 0, 0, 0], buttons), connected: true, mapping: 'standard', id: 'Pad' });
  vi.stubGlobal('navigator', { getGamepads: () => (there ? [standard()] : []) });
  const polled = new Pad((action: Action) =>
    acted.push(action.name === 'grip' ? `${action.grip}${action.down ? '+' : '-'}` : action.name),
  );
  return {
    pad: polled,
    press(...indices: number[]) {
      buttons = Object.fromEntries(indices.map((index) => [index, 1]));
      polled.poll();
      return acted.splice(0);
    },
    unplug() {
      there = false;
      polled.poll();
      return acted.splice(0);
    },
  };
}

test('north is held to capture, with Menu to release', () => {
  const { press } = pressed();
  expect(press(3)).toEqual(['close+']);
  expect(press()).toEqual(['close-']);
  expect(press(9)).toEqual([]);
  expect(press(9, 3)).toEqual(['open+']);
  expect(press(3)).toEqual([]);
  expect(press()).toEqual(['open-']);
});

test('Menu alone steps the camera as it comes up; with another button it does not', () => {
  const { press } = pressed();
  expect([press(9), press()]).toEqual([[], ['step camera']]);
  expect([press(9), press(9, 8), press(9), press()]).toEqual([[], ['fly orbiter'], [], []]);
  expect([press(9), press(9, 12), press()]).toEqual([[], [], []]);
});

test('what is held is let go with the pad, and when the sticks are taken away', () => {
  const first = pressed();
  first.press(3);
  expect(first.unplug()).toEqual(['close-']);
  const second = pressed();
  second.press(3);
  second.pad.disarm();
  expect(second.press(3)).toEqual(['close-']);
  expect(second.press()).toEqual([]);
});

test('east stops, with Menu too', () => {
  const { press } = pressed();
  expect(press(1)).toEqual(['stop']);
  press();
  press(9);
  expect(press(9, 1)).toEqual(['stop']);
});

test('the THC moves the arm or the orbiter, never both; the RHC and the telescope stay', () => {
  const value = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7] as const;
  const rest = { rotation: [0.4, 0.5, 0.6], drive: 0, telescope: 0.7 };
  expect(routed(value, false, false)).toEqual({ ...rest, translation: [0.1, 0.2, 0.3], orbiter: [0, 0, 0] });
  expect(routed(value, false, true)).toEqual({ ...rest, translation: [0, 0, 0], orbiter: [0.1, 0.2, 0.3] });
});

test('driving one joint, X drives it unless it flies the orbiter', () => {
  const value = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0] as const;
  expect(routed(value, true, false)).toMatchObject({
    translation: [0, 0, 0],
    rotation: [0, 0, 0],
    drive: 0.1,
  });
  expect(routed(value, true, true)).toMatchObject({ drive: 0, orbiter: [0.1, 0.2, 0.3] });
});

import { expect, test } from 'vitest';
import { isZero, sum, ZERO } from '../src/input/deflection';
import { deflection, shape } from '../src/input/gamepad';
import { ramp } from '../src/input/keyboard';
import { ACTION_KEYS, AXIS_KEYS } from '../src/input/keymap';

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
  expect(deflection(pad([0, -1, 0, 0]))).toEqual([1, 0, 0, 0, 0, 0]);
  expect(deflection(pad([1, 0, 0, 0]))).toEqual([0, 1, 0, 0, 0, 0]);
  expect(deflection(pad([0, 0, 0, 0], { 6: 1 }))).toEqual([0, 0, -1, 0, 0, 0]);
  expect(deflection(pad([0, 0, 0, 0], { 7: 1 }))).toEqual([0, 0, 1, 0, 0, 0]);
});

test('the right stick pitches and yaws; the bumpers roll', () => {
  expect(deflection(pad([0, 0, 0, -1]))).toEqual([0, 0, 0, 0, 1, 0]);
  expect(deflection(pad([0, 0, 1, 0]))).toEqual([0, 0, 0, 0, 0, 1]);
  expect(deflection(pad([0, 0, 0, 0], { 4: 1 }))).toEqual([0, 0, 0, -1, 0, 0]);
});

test('both devices together stay within full deflection', () => {
  expect(sum([0.8, -0.5, 0, 0, 0, 0], [0.8, -0.2, 0, 0, 0, 0])).toEqual([1, -0.7, 0, 0, 0, 0]);
  expect(isZero(sum(ZERO, ZERO))).toBe(true);
});

test('every stick axis has a key for either side, and no key two meanings', () => {
  const sides = new Set([...AXIS_KEYS.values()].map(({ axis, sign }) => `${axis}${sign}`));
  expect(sides.size).toBe(12);
  expect([...AXIS_KEYS.keys()].filter((code) => ACTION_KEYS.has(code))).toEqual([]);
});

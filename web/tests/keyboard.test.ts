import { expect, test } from 'vitest';
import { ramp } from '../src/input/keyboard';

test('a key reaches full deflection in 0.35 s and zero in 0.15 s', () => {
  expect(ramp(0, 1, 0.175)).toBeCloseTo(0.5);
  expect(ramp(0, 1, 0.36)).toBe(1);
  expect(ramp(1, 0, 0.075)).toBeCloseTo(0.5);
  expect(ramp(-1, 0, 0.16)).toBe(0);
});

test('a key deflection changes its sign through zero', () => {
  expect(ramp(0.1, -1, 0.1)).toBe(0);
  expect(ramp(0, -1, 0.035)).toBeCloseTo(-0.1);
});

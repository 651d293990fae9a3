import { expect, test } from 'vitest';
import { isZero, sum, ZERO } from '../src/input/deflection';

test('the sum of all devices stays within full deflection', () => {
  const both = sum([0.8, -0.5, 0, 0, 0, 0, 0], [0.8, -0.2, 0, 0, 0, 0, 0]);
  expect(both.slice(0, 2)).toEqual([1, -0.7]);
  expect(isZero(sum(ZERO, ZERO))).toBe(true);
});

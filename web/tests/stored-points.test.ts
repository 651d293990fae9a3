import { expect, test } from 'vitest';
import { firstShown, startPoint } from '../src/panel/target/stored-points';

test('a long list of points shows the next point and the point before it', () => {
  expect(firstShown(1, 4)).toBe(0);
  expect(firstShown(1, 12)).toBe(0);
  expect(firstShown(6, 12)).toBe(4);
  expect(firstShown(12, 12)).toBe(7);
  expect(firstShown(0, 0)).toBe(0);
});

test('a sequence starts at its next point, or else at its first point', () => {
  expect(startPoint('AUTO 1', { mode: 'AUTO 1', point: 3 }, 4)).toBe(3);
  expect(startPoint('AUTO 1', { mode: 'AUTO 1', point: 5 }, 4)).toBe(1);
  expect(startPoint('AUTO 2', { mode: 'AUTO 1', point: 3 }, 2)).toBe(1);
  expect(startPoint('AUTO 3', { mode: 'AUTO 1', point: 3 }, 0)).toBe(0);
});

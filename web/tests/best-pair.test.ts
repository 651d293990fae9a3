import { expect, test } from 'vitest';
import { between } from '../src/cameras/best-pair';
import { degree } from './camera-values';

test('two lines of sight are at most 90° apart', () => {
  expect(between([1, 0, 0], [0, 1, 0], [0, 0, 0]) / degree).toBeCloseTo(90);
  expect(between([1, 0, 0], [-1, 0, 0], [0, 0, 0]) / degree).toBeCloseTo(0);
  expect(between([1, 0, 0], [-1, 1, 0], [0, 0, 0]) / degree).toBeCloseTo(45);
});

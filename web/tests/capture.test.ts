import { expect, test } from 'vitest';
import { Capture } from '../src/input/capture';
import { DEFAULTS } from '../src/input/defaults';
import type { Reading } from '../src/input/reading';

function look(axes: readonly number[], ...down: number[]): Reading {
  const buttons = Array.from({ length: 12 }, (_, i) => ({ pressed: down.includes(i), value: 0 }));
  return { axes, buttons };
}

test('the axis that moved farthest is captured, whatever its rest position', () => {
  const capture = new Capture(DEFAULTS.pad);
  expect(capture.look(look([0, -1]))).toBeNull();
  expect(capture.look(look([0.2, -0.8]))).toBeNull();
  expect(capture.look(look([0.2, -0.3]))).toEqual({ source: 'a1', sign: 1 });
});

test('a button is captured when it is pressed; Menu is captured when it is released alone', () => {
  const capture = new Capture(DEFAULTS.pad);
  capture.look(look([], 3));
  expect(capture.look(look([], 3, 9))).toBeNull();
  expect(capture.look(look([], 3))).toEqual({ source: 'b9', sign: 1 });
  const other = new Capture(DEFAULTS.pad);
  other.look(look([]));
  other.look(look([], 9));
  expect(other.look(look([], 9, 1))).toEqual({ source: 'b9+b1', sign: 1 });
});

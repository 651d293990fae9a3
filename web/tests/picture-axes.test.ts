import { expect, test } from 'vitest';
import { stickToPicture } from '../src/panel/monitors/axes';

test('the angle of the picture is zero with +X into the picture, +Y right, +Z down', () => {
  expect(
    stickToPicture([
      [0, 0, -1],
      [1, 0, 0],
      [0, -1, 0],
    ]),
  ).toBeCloseTo(0);
  expect(
    stickToPicture([
      [0, 0, 1],
      [-1, 0, 0],
      [0, -1, 0],
    ]),
  ).toBeCloseTo(Math.PI);
});

import { expect, test } from 'vitest';
import { BAR, place } from '../src/panel/joints/joint-scale';

const joint = { hard: [-180, 180], soft: [-177.4, 177.4], reach: [-175.4, 175.4] } as const;

test('a joint bar is linear between reach limits; its zones have equal width', () => {
  expect(place(joint, 0)).toBeCloseTo(BAR / 2);
  expect(place(joint, -175.4)).toBeCloseTo(18);
  expect(place(joint, 87.7)).toBeCloseTo(BAR / 2 + (BAR - 36) / 4);
  expect(place(joint, 177.4)).toBeCloseTo(BAR - 9);
  expect(place(joint, 180)).toBe(BAR);
  expect(place(joint, -200)).toBe(0);
});

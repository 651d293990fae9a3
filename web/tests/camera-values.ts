import { expect } from 'vitest';
import type { Camera } from '../src/link/protocol';

/** A camera, and a comparison of vectors. */

export const degree = Math.PI / 180;
export const still = { pan: 0, tilt: 0, zoom: 0 };

export function near(a: readonly number[], b: readonly number[]): void {
  a.forEach((value, i) => {
    expect(value).toBeCloseTo(b[i] ?? Number.NaN, 7);
  });
}

export const bay: Camera = {
  name: 'B',
  title: 'Test',
  body: 'place',
  position: [0, 0, 0],
  boresight: [1, 0, 0],
  up: [0, 0, 1],
  field_of_view: 60 * degree,
  kind: 'camera',
  pane: null,
  inside: '',
  drive: {
    zero: [1, 0, 0],
    lens: 0,
    pan: { least: -170 * degree, greatest: 170 * degree, rate: 0.2, slow: 0.02 },
    tilt: { least: -80 * degree, greatest: 80 * degree, rate: 0.2, slow: null },
    zoom: { least: 9 * degree, greatest: 77 * degree, rate: 0.1, slow: null },
  },
};

import { expect, test } from 'vitest';
import type { Strip } from '../src/link/protocol';
import { boundsOf, heights, path } from '../src/replay/strips';

test('a curve is a path with gaps; greater values are higher', () => {
  const strip = { low: 0, high: 2, limit: null } as Strip;
  const height = heights(strip);
  expect(height(2)).toBeLessThan(height(0));
  expect([height(2) > 0, height(0) < 1]).toEqual([true, true]);
  const text = path({ role: 'actual', times_s: [1, 2, 3, 4], values: [0, 1, null, 2] }, (value) => value);
  expect(text).toBe('M1 0.0000L2 1.0000M4 2.0000');
});

test('a constant strip has a finite height', () => {
  expect(heights({ low: 0, high: 0, limit: null } as Strip)(0)).toBeGreaterThan(0);
  expect(Number.isFinite(heights({ low: 3, high: 3, limit: null } as Strip)(3))).toBe(true);
});

test('a clearance has two thresholds, a rate has one limit', () => {
  expect(boundsOf({ limit: null, caution: 0.6, warning: 0.15 }).map(({ level }) => level)).toEqual([
    'caution',
    'warning',
  ]);
  expect(boundsOf({ limit: 1, caution: null, warning: null })).toEqual([{ level: 'limit', value: 1 }]);
});

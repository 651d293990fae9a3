import { expect, test } from 'vitest';
import { marks } from '../src/replay/axis';

test('the axis has at most ten round marks, none beyond the end', () => {
  for (const duration of [0.5, 12, 40.04, 512, 7200, 40_000]) {
    const times = marks({ from: 0, to: duration });
    expect(times.length).toBeLessThanOrEqual(10);
    expect(Math.max(...times)).toBeLessThan(duration);
  }
  expect(marks({ from: 0, to: 40.04 })).toEqual([0, 5, 10, 15, 20, 25, 30, 35]);
});

test('the marks of a zoomed axis are those of its span', () => {
  expect(marks({ from: 21, to: 31 })).toEqual([21, 22, 23, 24, 25, 26, 27, 28, 29, 30]);
  expect(marks({ from: 12.1, to: 14.1 })[0]).toBeCloseTo(12.2);
});

import { expect, test } from 'vitest';
import { following, LEAST_S, lengthOf, partOf, zoomed } from '../src/replay/span';

test('zooming keeps the playhead in place and the span within the run', () => {
  const whole = { from: 0, to: 600 };
  const closer = zoomed(whole, 2, 300, 600);
  expect(closer).toEqual({ from: 150, to: 450 });
  expect(partOf(closer, 300)).toBe(partOf(whole, 300));
  expect(zoomed(closer, 0.5, 300, 600)).toEqual(whole);
  expect(zoomed(closer, 1 / 8, 300, 600)).toEqual(whole);
  expect(zoomed(whole, 1e6, 600, 600)).toEqual({ from: 600 - LEAST_S, to: 600 });
  expect(zoomed({ from: 0, to: 1 }, 2, 0.5, 1)).toEqual({ from: 0, to: 1 });
});

test('a span follows the playhead and stays within the run', () => {
  const span = { from: 100, to: 200 };
  expect(following(span, 150, 600)).toBe(span);
  for (const position of [201, 599, 99, 0, 600]) {
    const moved = following(span, position, 600);
    expect(lengthOf(moved)).toBe(100);
    expect(moved.from).toBeGreaterThanOrEqual(0);
    expect(moved.to).toBeLessThanOrEqual(600);
    expect(position).toBeGreaterThanOrEqual(moved.from);
    expect(position).toBeLessThanOrEqual(moved.to);
  }
});

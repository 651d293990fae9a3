import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { BAR, coordinateAt, place } from '../src/panel/joints/joint-scale';
import { Paced } from '../src/panel/parts/paced';

beforeEach(() => {
  vi.useFakeTimers();
});

afterEach(() => {
  vi.useRealTimers();
});

test('master angles are sent at most 20 times a second; the last angles are always sent', () => {
  const sent: number[] = [];
  const paced = new Paced<number>(50, (value) => sent.push(value));
  for (let i = 0; i < 100; i += 1) {
    paced.put(i);
    vi.advanceTimersByTime(10);
  }
  vi.advanceTimersByTime(200);
  expect(sent.length).toBeLessThanOrEqual(21);
  expect([sent[0], sent.at(-1)]).toEqual([0, 99]);
  vi.advanceTimersByTime(1000);
  paced.put(7);
  expect(sent.at(-1)).toBe(7);
});

test('a position on a joint bar gives the coordinate at that position', () => {
  const joint = { hard: [-3, 3], soft: [-2.9, 2.9], reach: [-2.7, 2.7] } as const;
  for (let at = 0; at <= BAR; at += 8.5) expect(place(joint, coordinateAt(joint, at))).toBeCloseTo(at);
  expect([coordinateAt(joint, -5), coordinateAt(joint, BAR + 5)]).toEqual([-3, 3]);
});

import { expect, test } from 'vitest';
import type { Event as LogEvent, Recent, Strip } from '../src/link/protocol';
import { marks } from '../src/replay/axis';
import { KEPT_S, LastMinutes } from '../src/windows/last-minutes';
import { roundRange } from '../src/words/round-range';
import { unitsOf } from '../src/words/units';

const UNITS = unitsOf('SI');

const strip = (name: string, more: Partial<Strip> = {}): Strip => ({
  name,
  quantity: 'gap',
  curves: [{ role: 'actual', times_s: [], values: [] }],
  low: 0,
  high: 0,
  limit: null,
  caution: null,
  warning: null,
  shown: true,
  rests: true,
  ...more,
});
const CLEARANCE = strip('Clearance', { caution: 0.6, warning: 0.15 });
const ANGLE = strip('Elbow', { quantity: 'angle', rests: false });

/** Samples between two times [s], ten each second; both values are linear in time. */
function recent(from: number, to: number, more: Partial<Recent> = {}): Recent {
  const count = Math.round((to - from) * 10);
  const samples = Array.from({ length: count }, (_, i) => {
    const time_s = from + i / 10;
    return { time_s, values: [time_s / 100, -1 - time_s / 1000], worst: '' };
  });
  return { type: 'recent', strips: [], samples, lanes: [], ...more };
}

function begun(seconds: number): LastMinutes {
  const made = new LastMinutes();
  made.take(recent(0, seconds, { strips: [CLEARANCE, ANGLE] }));
  return made;
}

const line = (time_s: number): LogEvent => ({ time_s, kind: 'mode', level: 'info', text: `${time_s}` });

test('only selected strips have curves, which end at the newest value', () => {
  const made = begun(20);
  const { strips } = made.over({ from: 10, to: made.now }, ['Clearance'], UNITS);
  const [clearance, angle] = strips;
  expect(clearance?.curves[0]?.times_s.at(0)).toBeCloseTo(10);
  expect(clearance?.curves[0]?.times_s.at(-1)).toBe(made.now);
  expect(clearance?.curves[0]?.values.at(-1)).toBe(made.newest?.values[0]);
  expect(angle?.curves[0]?.times_s).toEqual([]);
});

test('the range of a strip contains its values, zero and the caution', () => {
  const made = begun(20);
  const { strips } = made.over({ from: 0, to: made.now }, ['Clearance', 'Elbow'], UNITS);
  const [clearance, angle] = strips;
  expect([clearance?.low, clearance?.high]).toEqual([0, 0.6]);
  expect(angle?.curves[0]?.values.at(0)).toBe(-1);
  expect(angle?.low).toBeLessThan(-1.0199);
  expect(angle?.high).toBeGreaterThanOrEqual(-1);
  expect(angle?.high).toBeLessThan(-0.9);
});

test('memory is bounded by the last minutes of a run', () => {
  const made = begun(1);
  for (let second = 1; second < 3600; second += 1) {
    made.take(recent(second, second + 1));
    made.note([line(second)]);
  }
  const { strips, events } = made.over({ from: 0, to: made.now }, ['Clearance'], UNITS);
  expect(strips[0]?.curves[0]?.values.length).toBeLessThanOrEqual(KEPT_S * 10 + 1);
  expect(events.length).toBeLessThanOrEqual(KEPT_S + 1);
  expect(made.now).toBeCloseTo(3599.9);
});

test('the last stretch of a lane ends now; earlier stretches are omitted', () => {
  const made = begun(20);
  const stretches = [
    { start_s: 0, end_s: 4, label: 'A', level: 'info' as const },
    { start_s: 4, end_s: 5, label: 'B', level: 'info' as const },
  ];
  made.take(recent(20, 21, { lanes: [{ name: 'MON 1', stretches }] }));
  made.take(recent(21, 22));
  const { lanes } = made.over({ from: 10, to: made.now }, [], UNITS);
  expect(lanes[0]?.stretches).toEqual([{ ...stretches[1], end_s: made.now }]);
});

test('a restart clears curves, lanes and log', () => {
  const made = begun(20);
  made.note([line(5), line(19)]);
  made.note([line(0)]);
  made.take(recent(0, 1, { strips: [CLEARANCE, ANGLE] }));
  expect(made.now).toBeCloseTo(0.9);
  const { strips, events } = made.over({ from: -60, to: made.now }, ['Clearance'], UNITS);
  expect(strips[0]?.curves[0]?.values).toHaveLength(10);
  expect(events.map(({ time_s }) => time_s)).toEqual([0]);
});

test('a missing quantity has no points', () => {
  const made = new LastMinutes();
  const samples = [{ time_s: 0, values: [null, 1], worst: '' }];
  made.take({ type: 'recent', strips: [CLEARANCE, ANGLE], samples, lanes: [] });
  const { strips } = made.over({ from: -1, to: 0 }, ['Clearance'], UNITS);
  expect(strips[0]?.curves[0]?.values).toEqual([]);
});

test.each([
  [0, 0.61, 1, [0, 0.8]],
  [0, 0.61, 100, [0, 0.8]],
  [0, 0, 1, [0, 0.2]],
  [-1.2, -1.0, 1, [-1.2, -1]],
  [3, 3, 1, [3, 4]],
])('the range from %d to %d is round if %d displayed units are one SI unit', (low, high, perSi, range) => {
  const [from, to] = roundRange(low, high, perSi);
  expect(from).toBeCloseTo(range[0] ?? NaN, 9);
  expect(to).toBeCloseTo(range[1] ?? NaN, 9);
});

test('a range is round in the displayed unit', () => {
  const [, high] = roundRange(0, 0.61, 1 / 0.0254);
  expect(high / 0.0254).toBeCloseTo(25, 9);
});

test('the axis has no marks before the start of the run', () => {
  expect(marks({ from: -100, to: 20 })).toEqual([0, 15]);
  expect(marks({ from: -30, to: 0 })).toEqual([]);
});

test('lanes and events end with the newest sample', () => {
  const made = begun(20);
  const stretch = { label: 'ORB UNL', level: 'info' } as const;
  const lane = [0, 5, 15].map((start_s) => ({ ...stretch, start_s, end_s: start_s + 5 }));
  made.take(recent(20, 20, { lanes: [{ name: 'Mode', stretches: lane }] }));
  made.note([line(4), line(16)]);
  const timed = made.over({ from: 0, to: made.now }, ['Clearance'], UNITS);
  expect(timed.strips[0]?.curves[0]?.times_s.at(-1)).toBe(made.now);
  expect(timed.events.length).toBe(2);
  expect(timed.lanes[0]?.stretches.length).toBe(3);
  expect(timed.lanes[0]?.stretches.at(-1)?.end_s).toBe(made.now);
});

import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { Arrivals } from '../src/link/arrivals';
import type { Event as LogEvent } from '../src/link/protocol';
import { Log } from '../src/page/log';
import type { EventsGroup } from '../src/panel/desk/events';
import { link, PERIOD_S, sent } from './sent-frames';

beforeEach(() => {
  vi.useFakeTimers();
});

afterEach(() => {
  vi.useRealTimers();
});

const event = (time_s: number, kind = 'mode'): LogEvent => ({ time_s, kind, level: 'info', text: 'A line' });

/** The log of a page with the telemetry delay `delay` [steps]. */
function opened(delay = 0) {
  const arrivals = new Arrivals(link());
  const lines: LogEvent[] = [];
  const group = { add: vi.fn((events: readonly LogEvent[]) => void lines.push(...events)), clear: vi.fn() };
  const log = new Log(group as unknown as EventsGroup, arrivals);
  const show = (time_s: number) => {
    arrivals.put(sent(Math.round(time_s / PERIOD_S), [delay, 0]), performance.now());
  };
  return { arrivals, lines, group, log, show };
}

test.each([
  ['a new rejection', event(10, 'refused'), true],
  ['a rejection 2 s old', event(8, 'refused'), true],
  ['a rejection older than 2 s', event(7.98, 'refused'), false],
  ['a line of another kind', event(10, 'blocked'), false],
])('%s sets the time of the last rejection: %s', (_, line, sets) => {
  const { log, show } = opened();
  show(10);
  vi.advanceTimersByTime(3000);
  log.add([event(10), line, event(10)]);
  expect(log.refusedAt).toBe(sets ? performance.now() : -Infinity);
});

test('a rejection before the first frame sets no time', () => {
  const { log, lines } = opened();
  log.add([event(0, 'refused')]);
  expect(log.refusedAt).toBe(-Infinity);
  expect(lines).toHaveLength(1);
});

test('the list is not drawn again without new lines', () => {
  const { group, log } = opened();
  log.add([]);
  expect(group.add).not.toHaveBeenCalled();
});

test('a line of the page has the time of the displayed frame', () => {
  const { lines, log, show } = opened(10);
  log.say('A line');
  show(10);
  vi.advanceTimersByTime(500);
  show(10.5);
  log.say('A line', 'controller', 'info');
  expect(lines.map(({ time_s, kind, level }) => ({ time_s, kind, level }))).toEqual([
    { time_s: 0, kind: 'page', level: 'caution' },
    { time_s: 10, kind: 'controller', level: 'info' },
  ]);
});

test('of the lines of the page, only a rejection sets the time of the last rejection', () => {
  const { lines, log, show } = opened();
  show(10);
  log.say('A line');
  expect(log.refusedAt).toBe(-Infinity);
  vi.advanceTimersByTime(3000);
  log.refuse('A reason');
  expect(log.refusedAt).toBe(performance.now());
  expect(lines.map(({ text }) => text)).toEqual(['A line', 'A reason']);
});

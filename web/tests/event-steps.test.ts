import { expect, it } from 'vitest';
import { AT, eventBeside, eventsUntil } from '../src/replay/event-steps';

const events = [1, 2, 2, 5].map((time_s) => ({ time_s }));

it('events at the playhead count as passed', () => {
  expect([0, 1, 1.5, 2, 4.9, 5, 9].map((position) => eventsUntil(events, position))).toEqual([
    0, 1, 1, 3, 3, 4, 4,
  ]);
  expect(eventsUntil([], 3)).toBe(0);
});

it('steps never return the event at the playhead', () => {
  expect(eventBeside(events, 2 + AT / 2, 1)?.time_s).toBe(5);
  expect(eventBeside(events, 2 - AT / 2, -1)?.time_s).toBe(1);
});

it('there is no event before the first or after the last one', () => {
  expect(eventBeside(events, 1, -1)).toBeUndefined();
  expect(eventBeside(events, 5, 1)).toBeUndefined();
});

it('forward steps reach the time of each event once', () => {
  const visited: number[] = [];
  let next = eventBeside(events, 0, 1);
  while (next) {
    visited.push(next.time_s);
    next = eventBeside(events, next.time_s, 1);
  }
  expect(visited).toEqual([1, 2, 5]);
});

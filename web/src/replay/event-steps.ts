/** Events of a recording before and after the playhead. */

import type { Event as LogEvent } from '../link/protocol';

/** Greatest time between the playhead and an event that counts as being at the playhead [s]. */
export const AT = 1e-3;

type Timed = Pick<LogEvent, 'time_s'>;

/** Returns the number of events up to a position [s]. `events` must be in the order of time. */
export function eventsUntil(events: readonly Timed[], position: number): number {
  const after = events.findIndex(({ time_s }) => time_s > position + AT);
  return after < 0 ? events.length : after;
}

/** Returns the first event after a position (`by` 1) or the last before it (`by` −1); undefined if there is none. */
export function eventBeside<T extends Timed>(
  events: readonly T[],
  position: number,
  by: 1 | -1,
): T | undefined {
  return by > 0
    ? events.find(({ time_s }) => time_s > position + AT)
    : events.findLast(({ time_s }) => time_s < position - AT);
}

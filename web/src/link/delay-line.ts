/** Delays frames by the scenario's delay before numbers or pictures show them, and tells how old these are. */

import { Silence } from '../basics/silence';
import type { Frame } from './protocol';

/** Data is stale if its age exceeds the set delay by more than this [s]. */
const STALE_S = 0.5;

export interface Seen {
  readonly frame: Frame;
  /** Time of arrival [ms, as performance.now()]. */
  readonly at: number;
}

/** Greatest time between two readings that counts [ms]: a page that stands still cannot draw. */
const MOST_MS = 250;

/** Age of displayed data, and the set delay [s]. */
export interface Age {
  readonly s: number;
  readonly set: number;
  /** Whether the page itself is late, because it has not displayed what arrived. */
  readonly undrawn: boolean;
}

/** Returns whether displayed data is stale. The page must mark stale data. */
export function isStale({ s, set }: Pick<Age, 's' | 'set'>): boolean {
  return s > set + STALE_S;
}

export class DelayLine {
  private shown: Seen | null = null;
  private underWay: Seen[] = [];
  /** Time since a frame was displayed last. */
  private readonly undrawn = new Silence(MOST_MS);

  /** `delay`: delay of every frame [s]. */
  constructor(readonly delay: number) {}

  /** Adds a frame. The first frame of a run is displayed at once, because there is no earlier frame to display. */
  put(seen: Seen): void {
    const before = this.underWay.at(-1) ?? this.shown;
    if (!before) this.undrawn.end(seen.at);
    if (!before || this.delay === 0 || seen.frame.tick < before.frame.tick) {
      this.shown = seen;
      this.underWay = [];
    } else this.underWay.push(seen);
  }

  /** The frame to display at `now` [ms]; null before the first one. */
  at(now: number): Seen | null {
    let through = 0;
    for (const { at } of this.underWay) {
      if (at + 1000 * this.delay > now) break;
      through += 1;
    }
    this.shown = this.underWay[through - 1] ?? this.shown;
    this.underWay.splice(0, through);
    return this.shown;
  }

  /** Called at `now` [ms] when a frame is on the page, or when nobody can see the page. */
  displayed(now: number): void {
    this.undrawn.end(now);
  }

  /**
   * Age at `now` [ms] of what the page displays: of the frame that is due, and at least the time without a drawing.
   * While the run `stands`, there is no newer frame.
   */
  age(now: number, stands = false): Age {
    const seen = this.at(now);
    const [arrived, undrawn] = [
      seen && !stands ? Math.max(0, now - seen.at) / 1000 : 0,
      this.undrawn.at(now) / 1000,
    ];
    const s = seen ? Math.max(arrived, this.delay + undrawn) : 0;
    return { s, set: this.delay, undrawn: s > arrived };
  }
}

/** Delays frames by the scenario's delay before numbers or pictures show them. */

import type { Frame } from './protocol';

/** Data is stale if its age exceeds the set delay by more than this [s]. */
const STALE_S = 0.5;

export interface Seen {
  readonly frame: Frame;
  /** Time of arrival [ms, as performance.now()]. */
  readonly at: number;
}

/** Age of displayed data, and the set delay [s]. */
export interface Age {
  readonly s: number;
  readonly set: number;
}

/** Returns whether displayed data is stale. The page must mark stale data. */
export function isStale({ s, set }: Age): boolean {
  return s > set + STALE_S;
}

export class DelayLine {
  private shown: Seen | null = null;
  private underWay: Seen[] = [];

  /** `delay`: delay of every frame [s]. */
  constructor(readonly delay: number) {}

  /** Adds a frame. The first frame of a run is displayed at once, because there is no earlier frame to display. */
  put(seen: Seen): void {
    const before = this.underWay.at(-1) ?? this.shown;
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

  /** Age of the displayed frame at `now` [ms]. */
  age(now: number): Age {
    const seen = this.at(now);
    return { s: seen ? Math.max(0, now - seen.at) / 1000 : 0, set: this.delay };
  }
}

/** Frames on their way: figures and pictures show the flight as late as the scenario has it. */

import type { Frame } from './protocol';

/** What is older than it is meant to be by this much is stale [s]. */
const STALE_S = 0.5;

export interface Seen {
  readonly frame: Frame;
  /** When it came [ms, as performance.now()]. */
  readonly at: number;
}

/** How old something shown is, and how old it is meant to be [s]. */
export interface Age {
  readonly s: number;
  readonly set: number;
}

/** Older than it is meant to be, by so much that a person has to know. */
export function isStale({ s, set }: Age): boolean {
  return s > set + STALE_S;
}

export class DelayLine {
  private shown: Seen | null = null;
  private underWay: Seen[] = [];

  /** `delay`: how long every frame is under way [s]. */
  constructor(readonly delay: number) {}

  /** A frame came. The first of a flight is shown at once, since nothing can be shown before it. */
  put(seen: Seen): void {
    const before = this.underWay.at(-1) ?? this.shown;
    if (!before || this.delay === 0 || seen.frame.tick < before.frame.tick) {
      this.shown = seen;
      this.underWay = [];
    } else this.underWay.push(seen);
  }

  /** The frame to show at `now` [ms]; null: none has come. */
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

  /** How old at `now` [ms] what is shown is. */
  age(now: number): Age {
    const seen = this.at(now);
    return { s: seen ? Math.max(0, now - seen.at) / 1000 : 0, set: this.delay };
  }
}

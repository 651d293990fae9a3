/** The age of what a page displays. */

import { Silence } from '../basics/silence';
import type { Frames, Shows } from './frames';

/** Data is stale if its age exceeds the link's delay by more than this [s]. */
const STALE_S = 0.5;

/** Greatest time between two readings that counts [ms]: a page that stands still cannot draw. */
const MOST_MS = 250;

/** Age of displayed data, and the part of it that is the link's delay (`set`) [s]. */
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

export class Displayed {
  /** Time since a frame was displayed last. */
  private readonly undrawn = new Silence(MOST_MS);

  /** `shows`: what of the frames is displayed. */
  constructor(
    private readonly frames: Frames,
    private readonly shows: Shows,
  ) {}

  /** Called at `now` [ms] when a frame is on the page, or when nobody can see the page. */
  displayed(now: number): void {
    this.undrawn.end(now);
  }

  /**
   * Age at `now` [ms] of what the page displays: of the frame to show, and at least the time without a drawing. While
   * the run `stands`, there is no newer frame. `camera`: the camera of a picture, which may show a frame of its own.
   */
  age(now: number, stands = false, camera = ''): Age {
    const { frames, shows } = this;
    const seen = frames.at(shows, camera);
    if (!seen) this.displayed(now); // there is nothing to draw yet
    const [silent, undrawn] = [stands ? 0 : frames.silence(now), this.undrawn.at(now) / 1000];
    const s = (seen ? frames.behind(seen) : 0) + Math.max(silent, undrawn);
    return { s, set: frames.late(shows, camera), undrawn: undrawn > silent };
  }
}

/** Marks pictures and numbers that are old. It has its own clock, so that it goes on when nothing is drawn any more. */

import type { Pictures } from '../cameras/pictures';
import { type Age, isStale } from '../link/age';
import type { Arrivals } from '../link/arrivals';
import type { Level } from '../link/protocol';
import { setClass } from '../panel/parts/dom';

/** Time between two readings [ms]. */
const LOOK_MS = 100;

export class Freshness {
  /** Age of the oldest picture. */
  pictures: Age = { s: 0, set: 0, undrawn: false };
  /** Whether the log says that the pictures are not drawn. */
  private logged = false;
  private readonly timer: number;

  constructor(
    private readonly arrivals: Arrivals,
    private readonly drawn: Pick<Pictures, 'setAge'>,
    private readonly say: (text: string, level: Level) => void,
  ) {
    this.timer = window.setInterval(() => this.look(performance.now()), LOOK_MS);
  }

  /** Reads the ages at `now` [ms]. */
  look(now: number): void {
    const { arrivals } = this;
    if (document.hidden) arrivals.unseen(now);
    this.pictures = this.drawn.setAge((camera) => arrivals.age('camera', now, camera), now);
    setClass(document.body, 'stale', isStale(arrivals.age('telemetry', now)));
    const lost = isStale(this.pictures) && this.pictures.undrawn;
    if (lost && !this.logged)
      this.say('Pictures lost: the reason and what to do are in the pictures', 'caution');
    if (this.logged && !isStale(this.pictures)) this.say('Pictures are drawn again', 'info');
    this.logged = lost || (this.logged && isStale(this.pictures));
  }

  dispose(): void {
    clearInterval(this.timer);
  }
}

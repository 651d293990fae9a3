/** Puts drawn pictures on the page as soon as they are complete. */

import type { Put } from '../scene';
import { SLOWEST_MS } from '../scene/trial';
import { LOST } from './drawers';

/** Time between two attempts [ms]. */
const LOOK_MS = 3;

export class Putting {
  /** Completes the pictures that are not on the page yet; null if all are there. */
  private show: (() => boolean) | null = null;
  private timer = 0;
  private begun = 0;

  /**
   * `put` puts the pictures on the page if they are complete; `failed` is called with an error, or with the reason;
   * `slow` is called when the pictures have taken longer than `SLOWEST_MS`, with the time at which their drawing began
   * [ms]: it may give them up.
   */
  constructor(
    private readonly put: () => Put,
    private readonly failed: (error: unknown) => void,
    private readonly slow: (begun: number) => void,
  ) {}

  /** Whether the pictures drawn last are not on the page yet. */
  get waits(): boolean {
    return this.show !== null;
  }

  /**
   * Puts pictures on the page, now or when they are complete.
   *
   * @param begun time at which their drawing began [ms].
   * @param show completes the pictures when they are on the page; returns whether they are visible there.
   * @param done called after `show` has returned true. Its errors are not those of the pictures: they are thrown.
   */
  start(begun: number, show: () => boolean, done: () => void): void {
    this.begun = begun;
    this.show = show;
    this.look(done);
  }

  /** Gives up the pictures that are not on the page yet. */
  stop(): void {
    clearTimeout(this.timer);
    this.show = null;
  }

  private look(done: () => void): void {
    if (this.shows(done)) done();
  }

  /** Tries to put the pictures on the page; returns whether they are visible there. */
  private shows(done: () => void): boolean {
    const { show } = this;
    if (!show) return false;
    try {
      const put = this.put();
      if (performance.now() - this.begun > SLOWEST_MS) this.slow(this.begun);
      if (!this.show) return false;
      if (put === 'pending') {
        this.timer = window.setTimeout(() => this.look(done), LOOK_MS);
        return false;
      }
      this.show = null;
      if (put === 'drawn') return show();
      this.failed(LOST);
    } catch (error) {
      this.stop();
      this.failed(error);
    }
    return false;
  }
}

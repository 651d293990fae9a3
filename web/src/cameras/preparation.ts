/** Preparation of the drawer of the full profile, while the page shows the low profile: one at a time. */

import type { Frame } from '../link/protocol';
import type { Drawer } from './full-profile';

/** Makes the drawer; throws if `signal` is aborted. `progress` is called with the fraction that is done, 0 to 1. */
export type Make = (frame: Frame, signal: AbortSignal, progress: (done: number) => void) => Promise<Drawer>;

export class Preparation {
  private ending = new AbortController();
  private ready: Drawer | null = null;
  /** Settled when all preparations before have ended: an aborted one needs a moment. */
  private former: Promise<unknown> = Promise.resolve();

  /** `progress` is called with the fraction that is done, 0 to 1; null: no preparation is in progress. */
  constructor(
    private readonly make: Make,
    private readonly progress: (done: number | null) => void,
  ) {}

  /** Prepares a drawer, after the end of an earlier preparation. */
  start(frame: Frame): Promise<void> {
    this.end();
    this.ending = new AbortController();
    const { signal } = this.ending;
    const work = this.former.then(() => this.prepare(frame, signal));
    this.former = work.catch(() => {});
    return work;
  }

  /** Returns the drawer when it is ready, and from then on null. A drawer that has lost its graphics is dropped. */
  take(): Drawer | null {
    const { ready } = this;
    this.ready = null;
    if (!ready?.scene.isLost) return ready;
    ready.scene.dispose();
    this.progress(null);
    return null;
  }

  /** Ends the preparation, and drops a drawer that is ready. */
  end(): void {
    this.ending.abort();
    this.ready?.scene.dispose();
    this.ready = null;
    this.progress(null);
  }

  private async prepare(frame: Frame, signal: AbortSignal): Promise<void> {
    if (signal.aborted) return;
    try {
      const made = await this.make(frame, signal, (done) => signal.aborted || this.progress(done));
      if (signal.aborted) made.scene.dispose();
      else this.ready = made;
    } catch (error) {
      if (signal.aborted) return;
      this.progress(null); // the page keeps the low profile
      throw error;
    }
  }
}

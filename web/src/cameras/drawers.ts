/** The drawer of the pictures. A drawer that fails is replaced by a new one, as at the start of the page. */

import { sentenceOf } from '../page/notice';
import type { Drawer } from './full-profile';

/** Time after a failure until a new drawer is made [ms]; it doubles with each failure, up to the longest. */
const [FIRST_MS, LONGEST_MS] = [1000, 32_000];

/** Reasons why no pictures are drawn. */
export const LOST = 'The browser has withdrawn the graphics';
export const HIDDEN = 'The pictures are hidden in the page';

export class Drawers {
  /** Reason why no pictures are drawn, in a sentence without its full stop; empty if they are drawn. */
  fault = '';
  /** Number of drawers that have failed. */
  failures = 0;
  private drawer: Drawer;
  private failing = false;
  private wait = FIRST_MS;
  private dueAt = 0;

  /** `make` makes a drawer, and throws if this is impossible; `changed` is called with each new one. */
  constructor(
    private readonly make: () => Drawer,
    private readonly changed: (former: Drawer) => void,
  ) {
    this.drawer = make();
  }

  get present(): Drawer {
    return this.drawer;
  }

  /** Draws with another drawer from now on. */
  change(next: Drawer): void {
    const former = this.drawer;
    this.drawer = next;
    this.failing = false;
    this.changed(former);
  }

  /** Draws with a new drawer, as at the start of the page. */
  renew(): void {
    this.change(this.make());
  }

  /** Returns at `now` [ms] whether there is a drawer to draw with; after a failure, tries to make a new one. */
  ready(now: number): boolean {
    if (!this.failing) return true;
    if (now < this.dueAt) return false;
    try {
      this.renew();
    } catch (error) {
      this.postpone(now);
      this.fault = reasonOf(error);
    }
    return !this.failing;
  }

  /** Called at `now` [ms] when the present drawer has failed, with the error or with the reason. */
  failed(error: unknown, now: number): void {
    this.failures += 1;
    this.failing = true;
    this.fault = reasonOf(error);
    this.postpone(now);
  }

  /** Called when pictures are on the page, or are hidden there. */
  drawn(visible: boolean): void {
    this.fault = visible ? '' : HIDDEN;
    this.wait = FIRST_MS;
  }

  private postpone(now: number): void {
    this.dueAt = now + this.wait;
    this.wait = Math.min(LONGEST_MS, 2 * this.wait);
  }
}

function reasonOf(error: unknown): string {
  return typeof error === 'string' ? error : `The pictures cannot be drawn: ${sentenceOf(error)}`;
}

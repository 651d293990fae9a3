/** A switch that acts only after it was held for a set time. */

/** Time of a release that ends a hold without effect: the time of the true release is not known. */
export const NOT_HELD = -Infinity;

/** Time between two calls of `tick` from which on the page stood still in between [ms]. */
const STALL_MS = 250;

export class Hold {
  private since: number | null = null;
  private done = false;
  /** Time of the press, or of the last call of `tick` after it [ms]. */
  private looked = 0;
  /** Whether the set time was over at the last call of `tick`. */
  private over = false;

  constructor(
    readonly seconds: number,
    private readonly act: () => void,
  ) {}

  /** Starts to count the time; called when the switch is pressed at `now` [ms]. */
  press(now: number): void {
    if (this.since !== null) return;
    this.since = this.looked = now;
    this.done = this.over = false;
  }

  /**
   * Called when the switch is released at `now` [ms]. Acts if the switch was held long enough and no call of `tick` has
   * acted yet.
   */
  lift(now: number): void {
    if (this.part(now) >= 1) this.perform();
    this.since = null;
  }

  /**
   * Returns the elapsed fraction of the set time at `now` [ms]; acts once when it reaches 1. If the page stood still
   * since the last call, a release may not have been handled yet: then the next call acts.
   */
  tick(now: number): number {
    const part = this.part(now);
    const stalled = now - this.looked > STALL_MS && !this.over;
    this.looked = now;
    this.over = part >= 1;
    if (this.over && !stalled) this.perform();
    return Math.min(1, Math.max(0, part));
  }

  private part(now: number): number {
    return this.since === null ? 0 : (now - this.since) / (1000 * this.seconds);
  }

  private perform(): void {
    if (this.done) return;
    this.done = true;
    this.act();
  }
}

/** A switch that acts only after it was held for a set time. */

/** Time of a release that ends a hold without effect: the time of the true release is not known. */
export const NOT_HELD = -Infinity;

export class Hold {
  private since: number | null = null;
  private done = false;

  constructor(
    readonly seconds: number,
    private readonly act: () => void,
  ) {}

  /** Starts to count the time; called when the switch is pressed at `now` [ms]. */
  press(now: number): void {
    this.since ??= now;
  }

  /**
   * Called when the switch is released at `now` [ms]. Acts if the switch was held long enough and no call of `tick` has
   * acted yet.
   */
  lift(now: number): void {
    this.tick(now);
    this.since = null;
    this.done = false;
  }

  /** Returns the elapsed fraction of the set time at `now` [ms]; acts once when it reaches 1. */
  tick(now: number): number {
    if (this.since === null) return 0;
    const part = (now - this.since) / (1000 * this.seconds);
    if (part < 1) return Math.max(0, part);
    if (!this.done) {
      this.done = true;
      this.act();
    }
    return 1;
  }
}

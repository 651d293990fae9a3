/** A switch that acts only once it was held for a while. */

export class Hold {
  private since: number | null = null;
  private done = false;

  constructor(
    readonly seconds: number,
    private readonly act: () => void,
  ) {}

  /** It went down at `now` [ms]. */
  press(now: number): void {
    this.since ??= now;
  }

  /** The key came up at `now` [ms]. If no frame was drawn in time, it may have been held long enough. */
  lift(now: number): void {
    this.tick(now);
    this.since = null;
    this.done = false;
  }

  /** How much of its time is over at `now` [ms], 0 to 1; acts once when that is all of it. */
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

/** A switch that acts only after it was held for a set time. */

export class Hold {
  private since: number | null = null;
  private done = false;

  constructor(
    readonly seconds: number,
    private readonly act: () => void,
  ) {}

  /** Takes a press at `now` [ms]. */
  press(now: number): void {
    this.since ??= now;
  }

  /** Takes a release at `now` [ms]. If no picture was drawn in time, the key may have been held long enough. */
  lift(now: number): void {
    this.tick(now);
    this.since = null;
    this.done = false;
  }

  /** The elapsed part of the time at `now` [ms], 0 to 1; acts once at 1. */
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

/** Time for which nothing was heard of something, without the time for which the page itself stood still. */

export class Silence {
  private lasted = 0;
  private looked = 0;

  /** `most`: greatest time between two readings that counts [ms]; a longer one is a stall of the page. */
  constructor(private readonly most: number) {}

  /** Begins again at `at` [ms], because something was heard. */
  end(at = this.looked): void {
    this.lasted = 0;
    this.looked = Math.max(this.looked, at);
  }

  /** Returns the silence at `now` [ms]. */
  at(now: number): number {
    this.lasted += Math.min(this.most, Math.max(0, now - this.looked));
    this.looked = Math.max(this.looked, now);
    return this.lasted;
  }
}

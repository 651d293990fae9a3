/** Measurements of the last 10 s. */

const WINDOW_MS = 10_000;

export class Samples {
  private kept: { readonly at: number; readonly value: number }[] = [];

  /** Adds a value measured at `at` [ms, as performance.now()]. */
  add(value: number, at: number): void {
    this.kept.push({ at, value });
  }

  /** Returns the quantile `share` (0 to 1) of the values of the 10 s before `now` [ms]; null if there are no values. */
  part(share: number, now: number): number | null {
    this.kept = this.kept.filter(({ at }) => now - at <= WINDOW_MS);
    const sorted = this.kept.map(({ value }) => value).sort((a, b) => a - b);
    return sorted[Math.ceil(share * sorted.length) - 1] ?? null;
  }

  forget(): void {
    this.kept = [];
  }
}

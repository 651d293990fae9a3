/** Measurements of the last 10 s. */

const WINDOW_MS = 10_000;

export class Samples {
  private kept: { readonly at: number; readonly value: number }[] = [];

  /** Adds a value measured at `at` [ms, as performance.now()]. */
  add(value: number, at: number): void {
    this.kept.push({ at, value });
  }

  /** Quantile of the values at `now` [ms]; null if there are none. */
  part(share: number, now: number): number | null {
    this.kept = this.kept.filter(({ at }) => now - at <= WINDOW_MS);
    const sorted = this.kept.map(({ value }) => value).sort((a, b) => a - b);
    return sorted[Math.ceil(share * sorted.length) - 1] ?? null;
  }

  forget(): void {
    this.kept = [];
  }
}

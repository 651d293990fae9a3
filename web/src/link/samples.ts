/** What was measured in the last 10 s. */

const WINDOW_MS = 10_000;

export class Samples {
  private kept: { readonly at: number; readonly value: number }[] = [];

  /** A value measured at `at` [ms, as performance.now()]. */
  add(value: number, at: number): void {
    this.kept.push({ at, value });
  }

  /** The value that this share of them reaches at most, at `now` [ms]; null: none was measured. */
  part(share: number, now: number): number | null {
    this.kept = this.kept.filter(({ at }) => now - at <= WINDOW_MS);
    const sorted = this.kept.map(({ value }) => value).sort((a, b) => a - b);
    return sorted[Math.ceil(share * sorted.length) - 1] ?? null;
  }

  forget(): void {
    this.kept = [];
  }
}

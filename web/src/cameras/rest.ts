/** Detects whether the pictures have stopped changing. */

/** Time without a change after which the pictures are at rest [ms]. */
export const REST_MS = 300;
/**
 * Least change of a number of the scene [m, rad; also components of unit quaternions] that counts: a smaller one moves
 * nothing in a picture by a tenth of a pixel.
 */
export const LEAST = 1e-4;

export class Rest {
  /** Number of changes so far: pictures with the same number are equal. */
  changes = 0;
  private values: readonly number[] = [];
  private state: string | null = null;
  private since = 0;

  /**
   * Compares what the pictures show at `now` [ms] with the last change; returns whether it is at rest.
   *
   * @param values numbers of the scene: positions, angles.
   * @param state text that changes with everything else in the pictures.
   */
  look(values: readonly number[], state: string, now: number): boolean {
    const { values: before } = this;
    const same =
      state === this.state &&
      values.length === before.length &&
      values.every((value, i) => Math.abs(value - (before[i] ?? 0)) < LEAST);
    if (!same) {
      // Compared with the last change, not with the last frame: a slow motion must count, too.
      [this.values, this.state, this.since] = [values, state, now];
      this.changes += 1;
    }
    return now - this.since >= REST_MS;
  }
}

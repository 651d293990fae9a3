/** Lengths of the bars of conditions. */

import type { Condition } from '../../link/protocol';

/** Scale of a condition whose only bound is zero, by unit: 10 cm, 5°, 2 inches/s, 1°/s. */
const SCALES: Readonly<Record<string, number>> = { m: 0.1, rad: 0.087, 'm/s': 0.05, 'rad/s': 0.017 };

export class ConditionBars {
  /** Greatest bound that each condition has reported, by name. */
  private readonly bounds = new Map<string, number>();

  /** Stores the greatest bounds. A condition with two bounds reports only the nearer bound in a frame. */
  learn(conditions: readonly Condition[]): void {
    for (const { name, limit } of conditions) {
      const bound = Math.abs(limit);
      if (bound > (this.bounds.get(name) ?? 0)) this.bounds.set(name, bound);
    }
  }

  /** Returns the filled fraction of a condition's bar. The limit is at 0.5; a condition that holds is below 0.5. */
  part(condition: Condition): number {
    return Math.min(1, Math.max(0, 0.5 - 0.5 * this.margin(condition)));
  }

  /** Returns the margin as a fraction of the greatest bound; −1 (condition fails) if the value cannot be measured. */
  private margin({ name, unit, margin }: Condition): number {
    if (!Number.isFinite(margin)) return -1;
    return margin / (this.bounds.get(name) || SCALES[unit] || 1);
  }
}

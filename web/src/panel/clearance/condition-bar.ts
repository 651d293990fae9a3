/** Lengths of the bars of conditions. */

import type { Condition } from '../../link/protocol';

/** Scale of a condition whose bounds are all zero, by unit: 10 cm, 5°, 2 in/s, 1°/s. */
const SCALES: Readonly<Record<string, number>> = { m: 0.1, rad: 0.087, 'm/s': 0.05, 'rad/s': 0.017 };

export class ConditionBars {
  /** The greatest bound seen of each condition, by name. */
  private readonly bounds = new Map<string, number>();

  /** A condition reports the nearer of its two bounds; the scale is the greatest bound that was reported. */
  learn(conditions: readonly Condition[]): void {
    for (const { name, limit } of conditions) {
      const bound = Math.abs(limit);
      if (bound > (this.bounds.get(name) ?? 0)) this.bounds.set(name, bound);
    }
  }

  /** The filled part of a condition's bar: the limit is at 0.5, and a condition that holds is below it. */
  part(condition: Condition): number {
    return Math.min(1, Math.max(0, 0.5 - 0.5 * this.margin(condition)));
  }

  /** The margin as a fraction of the condition's scale; −1 (does not hold) if its value cannot be measured. */
  private margin({ name, unit, margin }: Condition): number {
    if (!Number.isFinite(margin)) return -1;
    return margin / (this.bounds.get(name) || SCALES[unit] || 1);
  }
}

/** In which order conditions stand, and how long their bars are. */

import type { Condition } from '../protocol';

/** Scale of a condition whose bounds are all zero, by unit: 10 cm, 5°, 2 in/s, 1°/s. */
const SCALES: Readonly<Record<string, number>> = { m: 0.1, rad: 0.087, 'm/s': 0.05, 'rad/s': 0.017 };
/** The order changes at once when a condition begins or ceases to hold, else no more often than this [s]. */
const STEADY_S = 3;

export class Ranking {
  /** The greatest bound seen of each condition, by name. */
  private readonly bounds = new Map<string, number>();
  private names: readonly string[] = [];
  private state = '';
  private at = Number.NEGATIVE_INFINITY;

  /** A condition's bound is the nearer of two: its scale is the greater, once that was seen. */
  learn(conditions: readonly Condition[]): void {
    for (const { name, limit } of conditions) {
      const bound = Math.abs(limit);
      if (bound > (this.bounds.get(name) ?? 0)) this.bounds.set(name, bound);
    }
  }

  /** The part of its bar that a condition fills: the limit is at 0.5, what holds is short of it. */
  part(condition: Condition): number {
    return Math.min(1, Math.max(0, 0.5 - 0.5 * this.margin(condition)));
  }

  /** The conditions, worst margin first; they keep their places for a while, so that they can be read. */
  order(conditions: readonly Condition[], time: number): readonly Condition[] {
    const state = conditions.map(({ name, holds }) => `${name} ${holds}`).join();
    if (state !== this.state || time < this.at || time - this.at >= STEADY_S) {
      this.state = state;
      this.at = time;
      this.names = [...conditions].sort((a, b) => this.rank(a) - this.rank(b)).map(({ name }) => name);
    }
    return this.names.flatMap((name) => conditions.find((each) => each.name === name) ?? []);
  }

  private rank(condition: Condition): number {
    const margin = this.margin(condition);
    return condition.holds ? Math.max(0, margin) : Math.min(margin, -Number.EPSILON);
  }

  /** The margin as a part of the condition's scale; what cannot be measured holds nowhere. */
  private margin({ name, unit, margin }: Condition): number {
    if (!Number.isFinite(margin)) return -1;
    return margin / (this.bounds.get(name) || SCALES[unit] || 1);
  }
}

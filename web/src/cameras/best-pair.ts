/** The best two cameras: both see the same target, from directions as different as possible. */

import type { Vec3 } from '../link/protocol';

/** Targets of a view, the most important last. */
export const TARGETS = ['tip', 'payload', 'gap'] as const;
export type Target = (typeof TARGETS)[number];

/** Result of a survey of one camera. */
export interface Sighting {
  readonly camera: string;
  readonly sees: ReadonlySet<Target>;
  /** Position of its lens in the scene [m]. */
  readonly lens: Vec3;
  /** Angle by which its picture is turned against the sticks [rad]. */
  readonly turned: number;
}

export interface Pair {
  /** Targets that both see. */
  readonly targets: readonly Target[];
  /** The two cameras; first the one whose picture is turned less against the sticks. */
  readonly cameras: readonly [Sighting, Sighting];
  /** Angle between their lines of sight, 0 to 90° [rad]. */
  readonly apart: number;
}

/** Sets of targets for a pair, the most important first; the angle is computed at the first target of a set. */
const PURPOSES: readonly (readonly [Target, ...Target[]])[] = [
  ['gap'],
  ['tip', 'payload'],
  ['tip'],
  ['payload'],
];
/** Angles above this count as equally good [rad]. */
const GOOD = (70 * Math.PI) / 180;

/**
 * The best pair of cameras. Only pairs that both see the same targets count, and of these only the pairs for the most
 * important targets. The best has the greatest angle between the lines of sight. Of several with more than `GOOD`, it
 * is the one whose more turned picture is turned least against the sticks.
 *
 * @param at positions of the targets in the scene; null if there is no such target.
 */
export function bestPair(
  sightings: readonly Sighting[],
  at: Readonly<Record<Target, Vec3 | null>>,
): Pair | null {
  for (const targets of PURPOSES) {
    const place = at[targets[0]];
    const seeing = sightings.filter(({ sees }) => targets.every((target) => sees.has(target)));
    if (!place || seeing.length < 2) continue;
    let best: Pair | null = null;
    let least = Number.POSITIVE_INFINITY;
    seeing.forEach((a, i) => {
      for (const b of seeing.slice(i + 1)) {
        const apart = between(a.lens, b.lens, place);
        // The turn of the pictures counts only among pairs that are equally good.
        const missing = 1e3 * Math.max(0, GOOD - apart) + Math.max(a.turned, b.turned);
        if (missing >= least) continue;
        least = missing;
        best = { targets, cameras: a.turned <= b.turned ? [a, b] : [b, a], apart };
      }
    });
    return best;
  }
  return null;
}

/** Angle between the lines from a point to two lenses, 0 to 90° [rad]. */
export function between(a: Vec3, b: Vec3, place: Vec3): number {
  const [u, v] = [a, b].map((lens) => lens.map((value, i) => value - (place[i] ?? 0)));
  if (!u || !v) return 0;
  const dot = u.reduce((sum, value, i) => sum + value * (v[i] ?? 0), 0);
  const sizes = Math.hypot(...u) * Math.hypot(...v);
  return sizes === 0 ? 0 : Math.acos(Math.min(1, Math.abs(dot) / sizes));
}

/** The best two cameras: both see the same target, and their directions of view differ as much as possible. */

import type { Vec3 } from '../link/protocol';

/** What a camera should show (not targets of a motion): tip, payload, minimum clearance. The last is most important. */
export const TARGETS = ['tip', 'payload', 'gap'] as const;
export type Target = (typeof TARGETS)[number];

/** Result of a survey of one camera. */
export interface Sighting {
  readonly camera: string;
  readonly sees: ReadonlySet<Target>;
  /** Position of the camera's lens in the scene [m]. */
  readonly lens: Vec3;
  /** Angle between the directions in the camera's picture and the directions of the sticks [rad]. */
  readonly turned: number;
}

export interface Pair {
  /** Targets that both cameras see. */
  readonly targets: readonly Target[];
  /** The two cameras; the first one has the smaller `turned`. */
  readonly cameras: readonly [Sighting, Sighting];
  /** Angle between the two lines of sight, at most 90° [rad]. */
  readonly apart: number;
}

/** Sets of targets for a pair, the most important first. The angle is measured at the first target of a set. */
const PURPOSES: readonly (readonly [Target, ...Target[]])[] = [
  ['gap'],
  ['tip', 'payload'],
  ['tip'],
  ['payload'],
];
/** All angles above this count as equally good [rad]. */
const GOOD = (70 * Math.PI) / 180;

/**
 * Returns the best pair of cameras, or null if no two cameras see the same target.
 *
 * The function takes the first set of `PURPOSES` that at least two cameras see, and compares all pairs of these
 * cameras. The best pair has the greatest angle between the lines of sight. All angles above `GOOD` count as equal.
 * If the angles are equal, the rating of a pair is the greater `turned` of its cameras. The smallest rating is best.
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
        // `turned` is at most π, so it decides only between pairs with equally good angles.
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

/** Returns the angle between the lines from a point to two lenses, at most 90° [rad]. */
export function between(a: Vec3, b: Vec3, place: Vec3): number {
  const [u, v] = [a, b].map((lens) => lens.map((value, i) => value - (place[i] ?? 0)));
  if (!u || !v) return 0;
  const dot = u.reduce((sum, value, i) => sum + value * (v[i] ?? 0), 0);
  const sizes = Math.hypot(...u) * Math.hypot(...v);
  return sizes === 0 ? 0 : Math.acos(Math.min(1, Math.abs(dot) / sizes));
}

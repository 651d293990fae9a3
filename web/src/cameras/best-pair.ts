/** Which two cameras show the work best: both see it, and from directions as different as they can be. */

import type { Vec3 } from '../link/protocol';

/** What there is to see, the most telling last. */
export const TARGETS = ['tip', 'payload', 'gap'] as const;
export type Target = (typeof TARGETS)[number];

/** What one camera sees now. */
export interface Sighting {
  readonly camera: string;
  readonly sees: ReadonlySet<Target>;
  /** Its lens in the scene [m]. */
  readonly lens: Vec3;
  /** Angle by which its picture is turned against the sticks [rad]. */
  readonly turned: number;
}

export interface Pair {
  /** What both see. */
  readonly targets: readonly Target[];
  /** The one whose picture goes more with the sticks first. */
  readonly cameras: readonly [Sighting, Sighting];
  /** Between their lines of sight, 0 to 90° [rad]. */
  readonly apart: number;
}

/** What a pair is for, the most telling first; the angle is taken at the first of each. */
const PURPOSES: readonly (readonly [Target, ...Target[]])[] = [
  ['gap'],
  ['tip', 'payload'],
  ['tip'],
  ['payload'],
];
/** Nearer to square than this is as good as square [rad]. */
const GOOD = (70 * Math.PI) / 180;

/**
 * The pair that sees the most telling thing which any two see: the one whose lines of sight are the most apart; of
 * those that are apart by more than `GOOD`, the one whose more turned picture is turned the least against the sticks.
 *
 * @param at where the targets are in the scene; null: there is none.
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
        // Turned pictures count only among pairs that are equally good.
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

/** Angle between the lines from a place to two lenses, as lines: 0 to 90° [rad]. */
export function between(a: Vec3, b: Vec3, place: Vec3): number {
  const [u, v] = [a, b].map((lens) => lens.map((value, i) => value - (place[i] ?? 0)));
  if (!u || !v) return 0;
  const dot = u.reduce((sum, value, i) => sum + value * (v[i] ?? 0), 0);
  const sizes = Math.hypot(...u) * Math.hypot(...v);
  return sizes === 0 ? 0 : Math.acos(Math.min(1, Math.abs(dot) / sizes));
}

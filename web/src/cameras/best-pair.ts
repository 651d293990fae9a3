/**
 * The rule that chooses the two cameras of the monitors.
 *
 * A picture has to show the *subjects* of the work: the tip, the payload, the target and the minimum clearance. The
 * rule compares all pairs of cameras that each show a subject, in this order:
 *
 * 1. Fewest cameras whose picture is turned by more than 100° against the sticks. Such a camera is chosen only if no
 *    other camera shows a subject.
 * 2. Fewest missing needs: the hand and what it works on (`Subjects.needs`).
 * 3. Kind: television cameras before windows, windows before engineering views.
 * 4. Score: what the two pictures show, see `score`.
 */

import type { Camera, Vec3 } from '../link/protocol';

export const SUBJECTS = ['tip', 'payload', 'target', 'gap'] as const;
export type Subject = (typeof SUBJECTS)[number];

/** Result of a survey of one camera. */
export interface Sighting {
  readonly camera: string;
  readonly kind: Camera['kind'];
  /** Whether the camera is on the arm or on a held payload: its view changes when the arm moves. */
  readonly onArm: boolean;
  /**
   * For each subject, how well the picture shows it, from 0 (not at all) to 1: visible fraction, apparent size and
   * light, multiplied. See `clarity`.
   */
  readonly shows: Readonly<Record<Subject, number>>;
  /** Position of the camera's lens in the scene [m]. */
  readonly lens: Vec3;
  /** Angle between the directions in the camera's picture and the directions of the sticks [rad]. */
  readonly turned: number;
}

export interface Pair {
  /** Subjects that both cameras show. */
  readonly both: readonly Subject[];
  /** The two cameras; the first one has the smaller `turned`. */
  readonly cameras: readonly [Sighting, Sighting];
  /** Angle between the two lines of sight to the first subject of `both`, at most 90°; null if there is none [rad]. */
  readonly apart: number | null;
}

/** Positions of the subjects in the scene; null if there is no such subject. */
export type Places = Readonly<Record<Subject, Vec3 | null>>;

/** Alternatives of which a pair has to show at least one: `['tip', 'payload']` is the hand that holds a payload. */
export type Need = readonly Subject[];

/** Importance of the subjects. */
const WEIGHT: Readonly<Record<Subject, number>> = { tip: 3, payload: 3, target: 3, gap: 2 };
/** All angles between lines of sight above this count as equally good [rad]. */
const GOOD = (70 * Math.PI) / 180;
/** The greatest `turned` of a picture that is easy to use: a quarter turn, and the tilt of a camera that looks down [rad]. */
export const CROSSED = (100 * Math.PI) / 180;
/** Part of its score that a pair loses if a picture is turned by 180°. */
const TURNED = 0.8;
/** Factor for the picture of a camera on the arm. */
const UNSTEADY = 0.6;
/** Apparent sizes between which a subject is easy to see, as multiples of the picture's width. */
const [LARGE, FILLS] = [0.05, 2];
/** Factor for a subject without light, and for a picture with the sun in it. */
const [DARK, GLARE] = [0.2, 0.6];

/** How a picture shows a subject. */
export interface Appearance {
  /** Fraction of the subject that is in the picture and not hidden. */
  readonly visible: number;
  /** Diameter of the subject, as a fraction of the picture's width. */
  readonly size: number;
  /** Light on the side of the subject that the camera sees, 0 to 1. */
  readonly light: number;
  /** Whether the sun is in the picture. */
  readonly glare: boolean;
}

/** Returns how well a picture shows a subject, 0 to 1. */
export function clarity({ visible, size, light, glare }: Appearance): number {
  const lit = DARK + (1 - DARK) * Math.min(1, light);
  return visible * Math.min(1, size / LARGE, FILLS / size) * lit * (glare ? GLARE : 1);
}

/** Returns the best pair of cameras, or null if fewer than two cameras show a subject. */
export function bestPair(sightings: readonly Sighting[], at: Places, needs: readonly Need[]): Pair | null {
  const useful = sightings.filter(({ shows }) => SUBJECTS.some((subject) => shows[subject] > 0));
  let best: readonly [Sighting, Sighting] | null = null;
  let bestRank: readonly number[] = [];
  useful.forEach((a, i) => {
    for (const b of useful.slice(i + 1)) {
      const rank = [
        crossed(a) + crossed(b),
        missing(a, b, needs),
        Math.max(tier(a), tier(b)),
        -score(a, b, at),
      ];
      if (best && !isLess(rank, bestRank)) continue;
      bestRank = rank;
      best = a.turned <= b.turned ? [a, b] : [b, a];
    }
  });
  return best && pairOf(best, at);
}

/** Returns a pair with the subjects that both cameras show. */
function pairOf([a, b]: readonly [Sighting, Sighting], at: Places): Pair {
  const both = SUBJECTS.filter((subject) => at[subject] && a.shows[subject] > 0 && b.shows[subject] > 0);
  const place = both[0] && at[both[0]];
  return { both, cameras: [a, b], apart: place ? between(a.lens, b.lens, place) : null };
}

/**
 * Returns the score of a pair. For each subject it adds twice what the better picture shows, and once what the other
 * shows; the other counts twice if the lines of sight differ by `GOOD` or more, because the operator then sees the
 * subject's position in depth. A pair loses part of the score in proportion to the greater `turned` of its pictures.
 */
export function score(a: Sighting, b: Sighting, at: Places): number {
  let sum = 0;
  for (const subject of SUBJECTS) {
    const place = at[subject];
    if (!place) continue;
    const [x, y] = [steady(a, subject), steady(b, subject)];
    const depth = Math.min(1, between(a.lens, b.lens, place) / GOOD);
    sum += WEIGHT[subject] * (2 * Math.max(x, y) + Math.min(x, y) * (1 + depth));
  }
  return sum * (1 - (TURNED * Math.max(a.turned, b.turned)) / Math.PI);
}

function steady({ onArm, shows }: Sighting, subject: Subject): number {
  return shows[subject] * (onArm ? UNSTEADY : 1);
}

/** Returns the number of needs that neither picture meets. */
function missing(a: Sighting, b: Sighting, needs: readonly Need[]): number {
  const met = (need: Need) => need.some((subject) => a.shows[subject] + b.shows[subject] > 0);
  return needs.filter((need) => !met(need)).length;
}

/** Returns whether a pair needs no help: no picture is turned too far, and it meets all needs. */
export function suffices({ cameras: [a, b] }: Pair, needs: readonly Need[]): boolean {
  return crossed(a) + crossed(b) + missing(a, b, needs) === 0;
}

function crossed({ turned }: Sighting): number {
  return turned > CROSSED ? 1 : 0;
}

function tier({ kind }: Sighting): number {
  return { camera: 0, window: 1, engineering: 2 }[kind];
}

/** Returns whether a list of numbers comes before another one of the same length, compared number by number. */
function isLess(a: readonly number[], b: readonly number[]): boolean {
  const i = a.findIndex((value, k) => value !== b[k]);
  return i >= 0 && (a[i] ?? 0) < (b[i] ?? 0);
}

/** Returns the angle between the lines from a point to two lenses, at most 90° [rad]. */
export function between(a: Vec3, b: Vec3, place: Vec3): number {
  const [u, v] = [a, b].map((lens) => lens.map((value, i) => value - (place[i] ?? 0)));
  if (!u || !v) return 0;
  const dot = u.reduce((sum, value, i) => sum + value * (v[i] ?? 0), 0);
  const sizes = Math.hypot(...u) * Math.hypot(...v);
  return sizes === 0 ? 0 : Math.acos(Math.min(1, Math.abs(dot) / sizes));
}

/** Position of a clearance on the gauge's scale, and the time until it is zero. */

/** The gauge's ends [m]: logarithmic, as the last centimetres count most. */
export const NEAREST = 0.05;
export const FARTHEST = 3;
/** Place on the gauge of a clearance [m]: 0 at its near end to 1 at its far end. */
export function placeOf(clearance: number): number {
  if (clearance <= NEAREST) return 0;
  return Math.min(1, Math.log(clearance / NEAREST) / Math.log(FARTHEST / NEAREST));
}

/** Seconds until contact at the present speed; null where the gap does not close, or not within ten minutes. */
export function contactIn(clearance: number, closing: number): number | null {
  if (clearance <= 0 || closing < STEADY) return null;
  const seconds = clearance / closing;
  return seconds < 600 ? seconds : null;
}

/** Slower than this, a gap neither closes nor opens [m/s]. */
export const STEADY = 1e-3;

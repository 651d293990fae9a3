/** Position of a clearance on the gauge's scale, and the time until the clearance is zero. */

/** The gauge's ends [m]; the scale is logarithmic because the last centimetres matter most. */
export const NEAREST = 0.05;
export const FARTHEST = 3;
/** Position of a clearance [m] on the gauge: 0 at its near end, 1 at its far end. */
export function placeOf(clearance: number): number {
  if (clearance <= NEAREST) return 0;
  return Math.min(1, Math.log(clearance / NEAREST) / Math.log(FARTHEST / NEAREST));
}

/**
 * Returns the time to contact at the present closing speed [s]. Null if there is contact, if the closing speed is below
 * `STEADY`, or if the time is ten minutes or more.
 */
export function contactIn(clearance: number, closing: number): number | null {
  if (clearance <= 0 || closing < STEADY) return null;
  const seconds = clearance / closing;
  return seconds < 600 ? seconds : null;
}

/** Below this rate, a clearance counts as constant [m/s]. */
export const STEADY = 1e-3;

/** Where an angle stands on a joint's bar. */

import type { JointInfo } from '../protocol';

/** Length of the bar, and of each of its four limit zones, which true scale would hide. */
export const BAR = 170;
const ZONE = 9;

/** Place on the bar, 0 at the lower hard stop to `BAR` at the upper, of an angle [rad]. */
export function place(joint: Pick<JointInfo, 'hard' | 'soft' | 'reach'>, angle: number): number {
  const angles = [joint.hard[0], joint.soft[0], joint.reach[0], joint.reach[1], joint.soft[1], joint.hard[1]];
  const places = [0, ZONE, 2 * ZONE, BAR - 2 * ZONE, BAR - ZONE, BAR];
  const above = angles.findIndex((limit) => angle < limit);
  if (above === 0) return 0;
  if (above === -1) return BAR;
  const [low, high] = [angles[above - 1] ?? 0, angles[above] ?? 0];
  const [from, to] = [places[above - 1] ?? 0, places[above] ?? BAR];
  return from + ((angle - low) / (high - low)) * (to - from);
}

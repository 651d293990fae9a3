/** Position of a joint's coordinate on its bar. */

import type { JointInfo } from '../../link/protocol';

/** Length of the bar, and length of each of its four limit zones. At true scale, the zones would be invisible. */
export const BAR = 170;
const ZONE = 9;
const PLACES = [0, ZONE, 2 * ZONE, BAR - 2 * ZONE, BAR - ZONE, BAR] as const;

type Limits = Pick<JointInfo, 'hard' | 'soft' | 'reach'>;

/** Coordinates at `PLACES` [rad or m]. */
function coordinates({ hard, soft, reach }: Limits): readonly number[] {
  return [hard[0], soft[0], reach[0], reach[1], soft[1], hard[1]];
}

/** Returns the position of a coordinate [rad or m] on the bar: 0 at the lower hard stop, `BAR` at the upper hard stop. */
export function place(joint: Limits, coordinate: number): number {
  return between(coordinates(joint), PLACES, coordinate);
}

/** Returns the coordinate [rad or m] at a position on the bar. */
export function coordinateAt(joint: Limits, at: number): number {
  return between(PLACES, coordinates(joint), at);
}

/**
 * Interpolates: returns the value in `to` that corresponds to `at` in `from`. Both lists increase. Outside `from`,
 * returns the first or the last value of `to`.
 */
function between(from: readonly number[], to: readonly number[], at: number): number {
  const above = from.findIndex((each) => at < each);
  if (above === 0) return to[0] ?? 0;
  if (above === -1) return to.at(-1) ?? 0;
  const [low, high] = [from[above - 1] ?? 0, from[above] ?? 0];
  const [start, end] = [to[above - 1] ?? 0, to[above] ?? 0];
  return start + ((at - low) / (high - low)) * (end - start);
}

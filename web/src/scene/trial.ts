/** Tries out how long the pictures of a profile take, with small pictures, before the page draws large ones with it. */

/** Longest time of a picture [ms]: slower ones are of no use for flying, and the page stops meanwhile. */
export const SLOWEST_MS = 2000;
/** Side lengths of the pictures that are tried [px]; the first one compiles the shaders. */
export const SIDES = [16, 16, 256] as const;

/** The pictures of a profile are too slow to fly by. */
export class TooSlow extends Error {
  /** `ms`: time that a picture takes or is expected to take [ms]. */
  constructor(readonly ms: number) {
    super(`A picture takes ${(ms / 1000).toFixed(1)} s`);
  }
}

/**
 * Returns the time that a picture of `area` [px] is expected to take: that of the small picture, and time for each of
 * the further pixels, as between the two pictures that were tried.
 */
export function expected(small: Tried, large: Tried, area: number): number {
  const each = Math.max(0, large.ms - small.ms) / (large.area - small.area);
  return small.ms + each * Math.max(0, area - small.area);
}

/** A picture's area [px] and the time that it took [ms]. */
export interface Tried {
  readonly area: number;
  readonly ms: number;
}

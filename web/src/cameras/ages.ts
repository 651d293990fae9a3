/** Writes into the pictures how old they are, and what to do if they are old. */

import { type Age, isStale } from '../link/age';
import type { Matrix } from '../panel/monitors/matrix';
import type { Monitors } from './monitors';

const RELOAD = 'The page tries again. If the pictures stay away, reload the page.';
const NO_POLYGONS = 'The station sends no new picture of 1972. Press 1972 for the usual picture.';

export type AgeOf = (camera: string) => Age;

/** State of the scene's pictures. */
export interface PictureState {
  /** Age of a camera's picture, and of those that show no frame of their own (the empty name). */
  readonly age: AgeOf;
  /** Reason why they are not drawn; empty if it is not known, or if they are drawn. */
  readonly fault: string;
  /** Text of pictures that are not old. */
  readonly fresh: 'live' | 'recorded';
}

/** Writes the ages at `now` [ms]; returns that of the latest picture. A picture in the look of 1972 has its own age. */
export function showAges(
  monitors: Monitors,
  matrix: Matrix,
  { age, fault, fresh }: PictureState,
  now: number,
): Age {
  const common = age('');
  const cure = isStale(common) && common.undrawn ? `${fault || 'The page does not draw'}. ${RELOAD}` : '';
  matrix.setAge(age, cure);
  let latest = common;
  for (const picture of monitors.both.flatMap(({ pictures }) => pictures)) {
    const drawn = age(picture.camera.name);
    const own = picture.polygons.ageOf(drawn, now);
    picture.setAge(own, fresh, own === drawn ? cure : isStale(own) ? NO_POLYGONS : '');
    if (own.s - own.set > latest.s - latest.set) latest = own;
  }
  return latest;
}

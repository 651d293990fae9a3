/** Writes into the pictures how old they are, and what to do if they are old. */

import { type Age, isStale } from '../link/age';
import type { Matrix } from '../panel/monitors/matrix';
import type { Monitors } from './monitors';

const RELOAD = 'The page tries again. If the pictures stay away, reload the page.';
const NO_POLYGONS = 'The station sends no new picture of 1972. Press 1972 for the usual picture.';

/** State of the scene's pictures. */
export interface PictureState {
  readonly age: Age;
  /** Reason why they are not drawn; empty if it is not known, or if they are drawn. */
  readonly fault: string;
  /** Text of pictures that are not old. */
  readonly fresh: 'live' | 'recorded';
}

/** Writes the ages at `now` [ms]; returns the age of the oldest. A picture in the look of 1972 has an age of its own. */
export function showAges(
  monitors: Monitors,
  matrix: Matrix,
  { age, fault, fresh }: PictureState,
  now: number,
): Age {
  const cure = isStale(age) && age.undrawn ? `${fault || 'The page does not draw'}. ${RELOAD}` : '';
  matrix.setAge(age, cure);
  let oldest = age;
  for (const picture of monitors.both.flatMap(({ pictures }) => pictures)) {
    const own = picture.polygons.ageOf(age, now);
    picture.setAge(own, fresh, own === age ? cure : isStale(own) ? NO_POLYGONS : '');
    if (own.s > oldest.s) oldest = own;
  }
  return oldest;
}

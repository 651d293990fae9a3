/** Where a clearance stands: on the gauge's scale, and against the two thresholds. */

import type { Level, WorkInfo } from '../protocol';

/** The gauge's ends [m]: logarithmic, as the last centimetres count most. */
export const NEAREST = 0.05;
export const FARTHEST = 3;
/** A level is left only when its threshold is passed by this part, so that a lamp does not flicker. */
const HYSTERESIS = 0.03;

type Thresholds = Pick<WorkInfo, 'caution' | 'warning'>;

/** Place on the gauge of a clearance [m]: 0 at its near end to 1 at its far end. */
export function placeOf(clearance: number): number {
  if (clearance <= NEAREST) return 0;
  return Math.min(1, Math.log(clearance / NEAREST) / Math.log(FARTHEST / NEAREST));
}

/** What a clearance [m] calls for, coming from what it called for before. */
export function levelOf(clearance: number, { caution, warning }: Thresholds, before: Level = 'info'): Level {
  const under = (threshold: number, was: boolean) => clearance < threshold * (was ? 1 + HYSTERESIS : 1);
  if (under(warning, before === 'warning')) return 'warning';
  return under(caution, before !== 'info') ? 'caution' : 'info';
}

/** Seconds until contact at the present speed; null where the gap does not close, or not within ten minutes. */
export function contactIn(clearance: number, closing: number): number | null {
  if (clearance <= 0 || closing < STEADY) return null;
  const seconds = clearance / closing;
  return seconds < 600 ? seconds : null;
}

/** Slower than this, a gap neither closes nor opens [m/s]. */
export const STEADY = 1e-3;

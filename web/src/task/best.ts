/** The best result of each scenario on this browser: the better grade, or the shorter time with the same grade. */

import type { Debrief } from '../link/protocol';
import type { Keeper } from '../page/local-storage';

export interface Best {
  readonly grade: NonNullable<Debrief['grade']>;
  /** Time of the run [s]. */
  readonly time: number;
}

const KEY = 'aftdeck.best.';

/** Returns the stored result of a scenario; null if there is none. */
export function bestOf(keeper: Keeper, scenario: string): Best | null {
  const [grade, time] = keeper.getItem(KEY + scenario)?.split(' ') ?? [];
  const seconds = Number(time);
  return grade && /^[A-D]$/.test(grade) && seconds > 0
    ? { grade: grade as Best['grade'], time: seconds }
    : null;
}

/** Stores a result if it is better than the stored one; returns whether it is. */
export function keepBest(keeper: Keeper, scenario: string, run: Best): boolean {
  const before = bestOf(keeper, scenario);
  if (before && !isBetter(run, before)) return false;
  keeper.setItem(KEY + scenario, `${run.grade} ${run.time}`);
  return true;
}

function isBetter(run: Best, before: Best): boolean {
  return run.grade < before.grade || (run.grade === before.grade && run.time < before.time);
}

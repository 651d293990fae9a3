/** All functions that can be assigned to keys, buttons and axes, looked up by their names. */

import type { Use as UseName } from '../link/protocol';
import { AXES } from './deflection';
import type { Acting } from './uses/acting';
import { FLYING } from './uses/flying';
import { LEFT_HAND, RIGHT_HAND } from './uses/sticks';
import type { Row, Use } from './uses/use';
import { LEAVE, WORKING } from './uses/working';

/** All rows of functions, in the order of the key map. */
export const ROWS: readonly Row[] = [...LEFT_HAND, ...RIGHT_HAND, ...FLYING, ...WORKING, LEAVE];

/** All functions by name. */
export const USES: ReadonlyMap<string, Use> = new Map(
  ROWS.flatMap(({ uses }) => uses.map((use) => [use.name, use])),
);

/** The function of each key, before any change. */
export const KEYBOARD: Readonly<Record<string, UseName>> = Object.fromEntries(
  [...USES.values()].flatMap(({ name, keys }) => keys.map((key) => [key, name])),
);

/** Performs a function that acts once at each press. */
export function perform(use: UseName, page: Acting): void {
  const does = USES.get(use)?.does;
  if (does && 'act' in does) does.act(page);
}

/** Returns the name of the function that deflects an axis to one side. */
export function axisUse(axis: number, sign: number): string {
  return `${sign < 0 ? '-' : '+'}${AXES[axis]}`;
}

/** Returns the name of a function on the page: `THC +X`, `rate hold`. */
export function labelOf(use: string): string {
  return USES.get(use)?.label ?? use;
}

/** The command delay as it is set and as it is measured; LINK DELAY, where commands take longer or do not come at all. */

import type { Lamp } from '../protocol';
import { STALE_S } from './picture';

/** A station that is well answers so soon after the delay that is set [s]: some control periods, and the way there. */
const SLACK_S = 0.25;

/** A delay measured so near to the one set is that one [s]. */
const USUAL_S = 0.1;

/** The delay for the rail: as set, and as measured where that differs; empty where there is none [s]. */
export function delayWords(set: number, measured: number | null): string {
  if (differs(set, measured)) return `set ${set.toFixed(2)}, measured ${measured.toFixed(2)} s`;
  return set > 0 ? `${set.toFixed(2)} s` : '';
}

/** Whether commands take another time than was set. */
export function differs(set: number, measured: number | null): measured is number {
  return measured !== null && Math.abs(measured - set) > USUAL_S;
}

/** `age`: of the newest frame; `set`, `measured`: from a stick to the frame that has flown it; null: none moved [s]. */
export function linkLamp(age: number, set: number, measured: number | null): Lamp | null {
  const name = 'LINK DELAY';
  if (age > STALE_S) return { name, level: 'caution', text: `silent for ${age.toFixed(0)} s` };
  if (measured !== null && measured > set + SLACK_S)
    return {
      name,
      level: 'caution',
      text: `commands take ${measured.toFixed(2)} s, ${set.toFixed(2)} s set`,
    };
  return set > 0 ? { name, level: 'info', text: `commands take ${set.toFixed(2)} s` } : null;
}

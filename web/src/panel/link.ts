/** LINK DELAY: commands that are under way for a while, longer than was set, or not at all. */

import type { Lamp } from '../protocol';
import { STALE_S } from './picture';

/** A station that is well answers so soon after the delay that is set [s]: some control periods, and the way there. */
const SLACK_S = 0.25;

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

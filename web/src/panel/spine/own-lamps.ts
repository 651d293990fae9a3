/** Lamps that the page lights: rejected command, link, age of pictures, controllers. */

import type { Controllers } from '../../input/controllers';
import { type Age, isStale } from '../../link/age';
import { type Delays, linkLamp } from '../rail/delays';
import type { LampName, SpineLamp } from './lamps';

/** Greatest length of a device's name in a lamp [characters]. */
const LAMP_NAME = 16;
/** Time for which a rejected command lights CHECK CRT [ms]. */
const REFUSAL_MS = 5000;

/** The page's own state. */
export interface Knows {
  /** Time of the last rejected command [ms, as performance.now()]. */
  readonly refusedAt: number;
  /** Time since the station's last message [s]. */
  readonly silence: number;
  readonly delays: Delays;
  /** Age of the pictures. */
  readonly pictures: Pick<Age, 's' | 'set'>;
  /** Null on a page that is too narrow for the controls. */
  readonly controllers: Pick<Controllers, 'lost' | 'waiting'> | null;
}

export function ownLamps(
  { refusedAt, silence, delays, pictures, controllers }: Knows,
  now: number,
): SpineLamp[] {
  const link = linkLamp(silence, delays);
  return [
    ...(now - refusedAt < REFUSAL_MS ? [caution('CHECK CRT', 'see the log')] : []),
    ...(link ? [link] : []),
    ...(isStale(pictures) ? [caution('CAMERA', `pictures ${pictures.s.toFixed(0)} s old`)] : []),
    ...(controllers ? controllerLamp(controllers) : []),
  ];
}

function controllerLamp({ lost, waiting }: Pick<Controllers, 'lost' | 'waiting'>): readonly SpineLamp[] {
  const [missing, waits] = [lost[0], waiting[0]];
  if (missing) return [caution('CONTROLLER', `${missing.short.slice(0, LAMP_NAME)} lost`)];
  if (!waits) return [];
  return [caution('CONTROLLER', waits.resting ? 'off centre: see Controllers' : 'centre both sticks')];
}

function caution(name: LampName, text: string): SpineLamp {
  return { name, level: 'caution', text };
}

/** The lamps that only the page can light: a refusal, its link, its pictures' age, its controllers. */

import type { Controllers } from '../../input/controllers';
import { type Age, isStale } from '../../link/delay-line';
import { type Delays, linkLamp } from '../rail/delays';
import type { LampName, SpineLamp } from './lamps';

/** As much of a device's name as a lamp holds [characters]. */
const LAMP_NAME = 16;
/** A refusal keeps CHECK CRT lit this long [ms]. */
const REFUSAL_MS = 5000;

/** What the page knows of itself. */
export interface Knows {
  /** When something was refused last [ms, as performance.now()]. */
  readonly refusedAt: number;
  /** Time since the station's last message [s]. */
  readonly silence: number;
  readonly delays: Delays;
  /** How old the pictures are. */
  readonly pictures: Age;
  /** Null on a page that cannot fly. */
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
  const [gone, waits] = [lost[0], waiting[0]];
  if (gone) return [caution('CONTROLLER', `${gone.short.slice(0, LAMP_NAME)} is gone`)];
  if (!waits) return [];
  return [
    caution('CONTROLLER', waits.resting ? 'rests off centre: see Controllers' : 'let go of both sticks'),
  ];
}

function caution(name: LampName, text: string): SpineLamp {
  return { name, level: 'caution', text };
}

/** The three delays, as they are set and as they are measured; LINK DELAY, where commands take longer or do not come. */

import type { SpineLamp } from '../spine/lamps';

/** A station that says nothing for so long is silent [s]. */
const SILENT_S = 0.5;

/** A station that is well answers so soon after the delay that is set [s]: some control periods, and the way there. */
const SLACK_S = 0.25;

/** A delay measured so near to the one set is that one [s]; figures and pictures take their time to be drawn. */
const USUAL_S = { command: 0.1, telemetry: 0.25, camera: 0.25 } as const;

const NAMES = ['command', 'telemetry', 'camera'] as const;
type Name = (typeof NAMES)[number];

const SHORT = { command: 'CMD', telemetry: 'TLM', camera: 'CAM' } as const;
const LONG = { command: 'Command', telemetry: 'Telemetry', camera: 'Camera' } as const;
const MANY = 'Delay';

/** A delay as the scenario sets it, and as it was in the last 10 s; null: nothing was measured [s]. */
export interface Delay {
  readonly set: number;
  readonly measured: number | null;
}

/**
 * From a stick to the frame that has flown it; from a frame's coming to figures, lamps and log that are of it; and to
 * pictures that are.
 */
export type Delays = Readonly<Record<Name, Delay>>;

/** The delays that there are for the rail, as set, and as measured where that differs; no text where there is none. */
export function delayWords(delays: Delays): { readonly label: string; readonly text: string } {
  const told = NAMES.filter((name) => delays[name].set > 0 || differs(name, delays[name]));
  const [only] = told;
  if (!only) return { label: MANY, text: '' };
  if (told.length === 1) {
    const { set, measured } = delays[only];
    if (!differs(only, delays[only])) return { label: `${LONG[only]} delay`, text: `${seconds(set)} s` };
    return { label: LONG[only], text: `set ${seconds(set)}, measured ${seconds(measured ?? 0)} s` };
  }
  const each = told.map((name) => {
    const { set, measured } = delays[name];
    return `${SHORT[name]} ${seconds(set)}${differs(name, delays[name]) ? ` (${seconds(measured ?? 0)})` : ''}`;
  });
  return { label: MANY, text: `${each.join(' · ')} s` };
}

/** The words need more room than those of one delay that is as it was set. */
export function areLong(delays: Delays): boolean {
  return (
    NAMES.filter((name) => delays[name].set > 0).length > 1 ||
    NAMES.some((name) => differs(name, delays[name]))
  );
}

/** Whether something takes another time than was set. */
function differs(name: Name, { set, measured }: Delay): boolean {
  return measured !== null && Math.abs(measured - set) > USUAL_S[name];
}

/** `silence`: since a frame came last [s]. */
export function linkLamp(silence: number, { command, telemetry, camera }: Delays): SpineLamp | null {
  const name = 'LINK DELAY';
  if (silence > SILENT_S) return { name, level: 'caution', text: `silent for ${silence.toFixed(0)} s` };
  const { set, measured } = command;
  if (measured !== null && measured > set + SLACK_S)
    return { name, level: 'caution', text: `commands take ${seconds(measured)} s, ${seconds(set)} s set` };
  const late = [
    ...(set > 0 ? [`commands take ${seconds(set)} s`] : []),
    ...(telemetry.set > 0 ? [`figures are ${seconds(telemetry.set)} s old`] : []),
    ...(camera.set > 0 ? [`pictures are ${seconds(camera.set)} s old`] : []),
  ];
  return late.length > 0 ? { name, level: 'info', text: late.join(', ') } : null;
}

function seconds(s: number): string {
  return s.toFixed(2);
}

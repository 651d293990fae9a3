/** The three delays as set and as measured, and the lamp LINK DELAY. */

import type { SpineLamp } from '../spine/lamps';

/** A station that sends no frame for this time counts as silent [s]. */
const SILENT_S = 0.5;

/** Commands may normally take this much longer than their set delay: some control periods and the transmission [s]. */
const SLACK_S = 0.25;

/** Greatest difference at which a measured delay counts as equal to the set delay [s]. Drawing takes some time. */
const USUAL_S = { command: 0.1, telemetry: 0.25, camera: 0.25 } as const;

const NAMES = ['command', 'telemetry', 'camera'] as const;
type Name = (typeof NAMES)[number];

const SHORT = { command: 'CMD', telemetry: 'TLM', camera: 'CAM' } as const;
const LONG = { command: 'Command', telemetry: 'Telemetry', camera: 'Camera' } as const;
const MANY = 'Delay';

/** A delay as set by the scenario, and as measured in the last 10 s (null without a measurement) [s]. */
export interface Delay {
  readonly set: number;
  readonly measured: number | null;
}

/**
 * `command`: from an input to the frame that used it. `telemetry`: from the arrival of a frame until its numbers, lamps
 * and log are displayed. `camera`: from the arrival of a frame until its pictures are displayed.
 */
export type Delays = Readonly<Record<Name, Delay>>;

/**
 * Returns the delays for the rail: as set, and also as measured if the measured delay differs. The text is empty if
 * there is no delay.
 */
export function delayWords(delays: Delays): { readonly label: string; readonly text: string } {
  const listed = NAMES.filter((name) => delays[name].set > 0 || differs(name, delays[name]));
  const [only] = listed;
  if (!only) return { label: MANY, text: '' };
  if (listed.length === 1) {
    const { set, measured } = delays[only];
    if (!differs(only, delays[only])) return { label: `${LONG[only]} delay`, text: `${seconds(set)} s` };
    return { label: LONG[only], text: `set ${seconds(set)}, measured ${seconds(measured ?? 0)} s` };
  }
  const each = listed.map((name) => {
    const { set, measured } = delays[name];
    return `${SHORT[name]} ${seconds(set)}${differs(name, delays[name]) ? ` (${seconds(measured ?? 0)})` : ''}`;
  });
  return { label: MANY, text: `${each.join(' · ')} s` };
}

/** Returns whether the text is long: it contains several delays, or a measured delay. */
export function areLong(delays: Delays): boolean {
  return (
    NAMES.filter((name) => delays[name].set > 0).length > 1 ||
    NAMES.some((name) => differs(name, delays[name]))
  );
}

/** Whether a measured delay differs from the set delay. */
function differs(name: Name, { set, measured }: Delay): boolean {
  return measured !== null && Math.abs(measured - set) > USUAL_S[name];
}

/** Returns the lamp LINK DELAY, or null if it is not lit; `silence`: time since the last frame [s]. */
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

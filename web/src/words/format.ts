/** Formats of numbers and times on the panel. */

import type { Unit, Units } from './units';

const DEGREE = 180 / Math.PI;

/** A number with this many decimals. Zero has no minus sign; if `signed`, zero and positive numbers have a `+`. */
export function fixed(value: number, decimals: number, signed = true): string {
  const digits = Math.abs(value).toFixed(decimals);
  const zero = Number(digits) === 0;
  if (value < 0 && !zero) return `−${digits}`;
  return signed ? `+${digits}` : digits;
}

/** An attitude [rad] as 0.0 to 359.9 degrees. */
export function attitude(radians: number): string {
  const tenths = Math.round(radians * DEGREE * 10);
  return ((((tenths % 3600) + 3600) % 3600) / 10).toFixed(1);
}

/** An angle [rad] or angular rate [rad/s] in degrees; `signed` as in `fixed`. */
export function degrees(radians: number, decimals = 1, signed = true): string {
  return fixed(radians * DEGREE, decimals, signed);
}

/** A length or speed [SI] in a unit for small values: no decimals if it is ten or more, no sign if it is positive. */
export function small(value: number, unit: Unit): string {
  const shown = value * unit.perSi;
  return fixed(shown, Math.abs(shown) < 9.95 ? unit.decimals : 0, false);
}

/** Lengths from which on the greater unit is used: 2 ft, or 1 m [m]. */
const [FEET_FROM, METRES_FROM] = [0.6096, 1];
const FOOT = 0.3048;

/** A length [m] with its unit: `5.2 in`, `6.5 ft`, `42 cm`, `1.28 m`. */
export function lengthText(size: number, { gap, name }: Pick<Units, 'gap' | 'name'>): string {
  if (name === 'SI')
    return size < METRES_FROM ? `${small(size, gap)} ${gap.name}` : `${fixed(size, 2, false)} m`;
  return size < FEET_FROM ? `${small(size, gap)} ${gap.name}` : `${fixed(size / FOOT, 1, false)} ft`;
}

/** A duration [s] in words: `47 s`, `3 min 5 s`. */
export function durationText(time: number): string {
  const [minutes, seconds] = [Math.floor(time / 60), Math.floor(time % 60)];
  return minutes > 0 ? `${minutes} min ${seconds} s` : `${seconds} s`;
}

/** Mission elapsed time [s] as `ddd/hh:mm:ss`. */
export function missionTime(seconds: number): string {
  const whole = Math.max(0, Math.floor(seconds));
  return `${pad(Math.floor(whole / 86400), 3)}/${clock(whole % 86400)}`;
}

/** A picture's time code: mission time and hundredths, `hh:mm:ss.cc`. */
export function timeCode(seconds: number): string {
  const hundredths = Math.max(0, Math.floor(seconds * 100 + 1e-6));
  return `${clock(Math.floor(hundredths / 100))}.${pad(hundredths % 100, 2)}`;
}

/** Seconds as `hh:mm:ss`. */
export function clock(seconds: number): string {
  const whole = Math.max(0, Math.floor(seconds));
  const minutes = Math.floor(whole / 60);
  return `${pad(Math.floor(minutes / 60), 2)}:${pad(minutes % 60, 2)}:${pad(whole % 60, 2)}`;
}

/** Returns the number in a keyed-in text; null if there is none. The minus sign may be `−` or a hyphen. */
export function parseNumber(text: string): number | null {
  const plain = text.trim().replace('−', '-');
  return /^[+-]?(\d+\.?\d*|\.\d+)$/.test(plain) ? Number(plain) : null;
}

function pad(value: number, width: number): string {
  return String(value).padStart(width, '0');
}

/** A text with a capital at its beginning. */
export function capitalised(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

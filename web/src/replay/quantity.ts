/** Formats of the numbers in strips and measures, with their units. */

import { type Measure, type Quantity, UNITS } from '../link/protocol';
import { degrees, fixed } from '../words/format';
import type { Units } from '../words/units';

interface Shown {
  readonly unit: string;
  /** Displayed value of one SI unit. */
  readonly perSi: number;
  readonly text: (value: number) => string;
}

const DEGREE = 180 / Math.PI;
/** Decimals of the numbers that every page shows in their SI unit. */
const DECIMALS = { seconds: 2, ratio: 2, force: 0, impulse: 1, torque: 0, milliseconds: 0 };

/** Returns the format of a quantity. */
export function shown(quantity: Quantity, units: Units): Shown {
  const si = units.name === 'SI';
  const scaled = (unit: string, perSi: number, decimals: number): Shown => ({
    unit,
    perSi,
    text: (value) => fixed(value * perSi, decimals, false),
  });
  switch (quantity) {
    case 'time':
      return { unit: '', perSi: 1, text: (value) => minutes(value) };
    case 'count':
      return { unit: '', perSi: 1, text: (value) => fixed(value, Number.isInteger(value) ? 0 : 1, false) };
    case 'share':
      return scaled('%', 100, 0);
    case 'part of limit':
      return scaled('of limit', 1, 2);
    case 'length':
      return scaled(units.length.name, units.length.perSi, units.length.decimals);
    case 'gap': {
      const { name, perSi, decimals } = units.gap;
      return { unit: name, perSi, text: (value) => fixed(value * perSi, decimals, value < 0) };
    }
    case 'distance':
      return si ? scaled('m', 1, 2) : scaled('ft', 1 / 0.3048, 1);
    case 'speed':
      return scaled(units.speed.name, units.speed.perSi, 2);
    case 'angle':
      return { unit: '°', perSi: DEGREE, text: (value) => degrees(value, 1, value < 0) };
    case 'turn rate':
      return { unit: '°/s', perSi: DEGREE, text: (value) => degrees(value, 2, false) };
    case 'seconds':
    case 'ratio':
    case 'force':
    case 'impulse':
    case 'torque':
    case 'milliseconds':
      return scaled(UNITS[quantity], 1, DECIMALS[quantity]);
    case 'words':
      return { unit: '', perSi: 1, text: String };
  }
}

/** Returns a value with its unit; a dash if there is no value. */
export function withUnit(quantity: Quantity, value: number | null, units: Units): string {
  if (value === null) return '–';
  const { unit, text } = shown(quantity, units);
  return unit === '' || unit === '°' ? `${text(value)}${unit}` : `${text(value)} ${unit}`;
}

export function figure(measure: Measure, units: Units): string {
  if (measure.quantity === 'words') return measure.text;
  const value = withUnit(measure.quantity, measure.value, units);
  return measure.angle === null ? value : `${value}, ${withUnit('angle', measure.angle, units)}`;
}

/** Returns seconds as `mm:ss`, with hours if necessary, and with `decimals` decimal places. */
export function minutes(seconds: number, decimals = 0): string {
  const scale = 10 ** decimals;
  const whole = Math.floor(Math.max(0, seconds) * scale + 1e-6);
  const rest = decimals > 0 ? `.${String(whole % scale).padStart(decimals, '0')}` : '';
  const all = Math.floor(whole / scale);
  const hours = Math.floor(all / 3600);
  const two = (value: number) => String(value).padStart(2, '0');
  return `${hours > 0 ? `${hours}:` : ''}${two(Math.floor(all / 60) % 60)}:${two(all % 60)}${rest}`;
}

/** Numbers of strips and measures with their units, as the operator reads them. */

import { degrees, fixed } from '../format';
import type { Measure, Quantity } from '../protocol';
import type { Units } from '../units';

interface Shown {
  readonly unit: string;
  readonly text: (value: number) => string;
}

/** How a quantity is written. */
export function shown(quantity: Quantity, units: Units): Shown {
  const si = units.name === 'SI';
  const scaled = (perSi: number, decimals: number) => (value: number) =>
    fixed(value * perSi, decimals, false);
  switch (quantity) {
    case 'time':
      return { unit: '', text: (value) => minutes(value) };
    case 'count':
      return { unit: '', text: (value) => fixed(value, Number.isInteger(value) ? 0 : 1, false) };
    case 'share':
      return { unit: '%', text: scaled(100, 0) };
    case 'part of limit':
      return { unit: 'of limit', text: scaled(1, 2) };
    case 'ratio':
      return { unit: '', text: scaled(1, 2) };
    case 'length':
      return { unit: units.length.name, text: scaled(units.length.perSi, units.length.decimals) };
    case 'gap':
      return {
        unit: units.gap.name,
        text: (value) => fixed(value * units.gap.perSi, units.gap.decimals, value < 0),
      };
    case 'distance':
      return si ? { unit: 'm', text: scaled(1, 2) } : { unit: 'ft', text: scaled(1 / 0.3048, 1) };
    case 'speed':
      return { unit: units.speed.name, text: scaled(units.speed.perSi, 2) };
    case 'angle':
      return { unit: '°', text: (value) => degrees(value, 1, value < 0) };
    case 'turn rate':
      return { unit: '°/s', text: (value) => degrees(value, 2, false) };
    case 'milliseconds':
      return { unit: 'ms', text: scaled(1, 0) };
    case 'words':
      return { unit: '', text: String };
  }
}

/** A value with its unit; a dash where there is none. */
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

/** Seconds as `mm:ss`, with hours where there are any; tenths or hundredths on demand. */
export function minutes(seconds: number, decimals = 0): string {
  const scale = 10 ** decimals;
  const whole = Math.floor(Math.max(0, seconds) * scale + 1e-6);
  const rest = decimals > 0 ? `.${String(whole % scale).padStart(decimals, '0')}` : '';
  const all = Math.floor(whole / scale);
  const hours = Math.floor(all / 3600);
  const two = (value: number) => String(value).padStart(2, '0');
  return `${hours > 0 ? `${hours}:` : ''}${two(Math.floor(all / 60) % 60)}:${two(all % 60)}${rest}`;
}

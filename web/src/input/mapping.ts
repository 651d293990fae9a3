/**
 * Mapping of a kind of device, as plain data. Each binding assigns one function to a source, so no source can have two
 * functions. A source is a key by its position (`KeyW`), a button (`b3`), an axis (`a1`), or a button while another
 * button is held (`b9+b12`).
 */

import { clamp } from '../basics/clamp';
import { USES } from './keymap';

export const KINDS = [
  'keyboard',
  'pad',
  'thc pad',
  'rhc pad',
  'thc joystick',
  'rhc joystick',
  'spacemouse',
  'touch',
] as const;
export type Kind = (typeof KINDS)[number];

export interface Mapping {
  /** Fraction of an axis' travel, on both sides of its centre, that counts as zero. */
  readonly deadband: number;
  /** Share of x³ in the response to a deflection x: 0 gives x, 1 gives x³. */
  readonly expo: number;
  readonly bindings: Readonly<Record<string, string>>;
  /** Rest positions that the operator has set as zero, by axis number; a missing position is 0. */
  readonly centres: readonly number[];
}

/** Greatest deadband. */
export const MOST_DEADBAND = 0.5;
/** Greatest distance of a rest position from 0. */
export const MOST_OFFSET = 0.3;
/** Greatest number of bindings that the station accepts. */
export const MOST_BINDINGS = 96;

const SOURCE = /^(?:[ab]\d{1,2}|b\d{1,2}\+b\d{1,2}|[A-Z][A-Za-z0-9]{1,15})$/;

/** Returns the number in `a1` or `b3`; null for another kind of source. */
export function indexOf(source: string, letter: 'a' | 'b'): number | null {
  const index = source[0] === letter ? Number(source.slice(1)) : Number.NaN;
  return Number.isNaN(index) ? null : index;
}

/** Returns the deflection of an axis from its rest position, scaled to full deflection at both ends. */
export function centred(raw: number, centre: number): number {
  const from = clamp(raw) - centre;
  return from === 0 ? 0 : from / (from > 0 ? 1 - centre : 1 + centre);
}

/** Returns a deflection in [-1, 1] after deadband and expo. */
export function shape(value: number, { deadband, expo }: Pick<Mapping, 'deadband' | 'expo'>): number {
  const size = Math.min(1, Math.max(0, (Math.abs(value) - deadband) / (1 - deadband)));
  return size === 0 ? 0 : Math.sign(value) * ((1 - expo) * size + expo * size ** 3);
}

/** Returns the sources that have a function. */
export function sourcesOf(mapping: Mapping, use: string): readonly string[] {
  return Object.keys(mapping.bindings).filter((source) => mapping.bindings[source] === use);
}

/** Returns the axes and buttons that have a function, alone or together. */
export function assignedParts({ bindings }: Pick<Mapping, 'bindings'>): ReadonlySet<string> {
  return new Set(Object.keys(bindings).flatMap((source) => source.split('+')));
}

/**
 * Checks decoded data and returns it as a mapping.
 *
 * Throws an Error that names what is invalid.
 */
export function parseMapping(data: unknown): Mapping {
  if (typeof data !== 'object' || data === null) throw new Error('a mapping must be an object');
  const { deadband, expo, bindings, centres } = data as Record<string, unknown>;
  if (typeof bindings !== 'object' || bindings === null) throw new Error('a mapping must have bindings');
  const entries = Object.entries(bindings);
  if (entries.length > MOST_BINDINGS) throw new Error(`a mapping has at most ${MOST_BINDINGS} bindings`);
  for (const [source, use] of entries) {
    if (!SOURCE.test(source)) throw new Error(`“${source}” is not a key, button or axis`);
    if (typeof use !== 'string' || !USES.has(use)) throw new Error(`“${use}” is not a function`);
    if (source[0] === 'a' && USES.get(use)?.does.kind !== 'axis')
      throw new Error(`an axis cannot have the function “${use}”`);
  }
  if (!Array.isArray(centres)) throw new Error('a mapping must have centres');
  return {
    deadband: within(deadband, 0, MOST_DEADBAND, 'the deadband'),
    expo: within(expo, 0, 1, 'expo'),
    bindings: Object.fromEntries(entries),
    centres: centres.map((centre) => within(centre, -MOST_OFFSET, MOST_OFFSET, 'a centre')),
  };
}

function within(value: unknown, least: number, most: number, what: string): number {
  if (typeof value === 'number' && value >= least && value <= most) return value;
  throw new Error(`${what} must be between ${least} and ${most}, got ${value}`);
}

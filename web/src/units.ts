/** The operator's units: how lengths [m] and speeds [m/s] are shown and keyed in. */

import type { Welcome } from './protocol';

export type UnitName = Welcome['units'];

export interface Unit {
  readonly name: string;
  /** Shown value of one metre, or of one metre per second. */
  readonly perSi: number;
  readonly decimals: number;
}

export interface Units {
  readonly name: UnitName;
  readonly length: Unit;
  readonly speed: Unit;
  /** Of gaps and small errors, and of how fast they close. */
  readonly gap: Unit;
  readonly creep: Unit;
}

const FEET_INCHES: Units = {
  name: 'ft-in',
  length: { name: 'in', perSi: 1 / 0.0254, decimals: 1 },
  speed: { name: 'ft/s', perSi: 1 / 0.3048, decimals: 2 },
  gap: { name: 'in', perSi: 1 / 0.0254, decimals: 1 },
  creep: { name: 'in/s', perSi: 1 / 0.0254, decimals: 1 },
};

const SI: Units = {
  name: 'SI',
  length: { name: 'm', perSi: 1, decimals: 3 },
  speed: { name: 'm/s', perSi: 1, decimals: 3 },
  gap: { name: 'cm', perSi: 100, decimals: 1 },
  creep: { name: 'cm/s', perSi: 100, decimals: 1 },
};

export function unitsOf(name: UnitName): Units {
  return name === 'SI' ? SI : FEET_INCHES;
}

/** Operator's units, in which lengths [m], speeds [m/s] and masses [kg] are displayed and keyed in. */

import type { Welcome } from '../link/protocol';

export type UnitName = Welcome['units'];

export interface Unit {
  readonly name: string;
  /** Displayed value of one SI unit: of 1 m, 1 m/s or 1 kg. */
  readonly perSi: number;
  readonly decimals: number;
}

export interface Units {
  readonly name: UnitName;
  readonly length: Unit;
  readonly speed: Unit;
  /** Units of clearances and small errors (`gap`) and of their rates (`creep`). */
  readonly gap: Unit;
  readonly creep: Unit;
  /** Unit of masses. */
  readonly mass: Unit;
}

const FEET_INCHES: Units = {
  name: 'ft-in',
  length: { name: 'in', perSi: 1 / 0.0254, decimals: 1 },
  speed: { name: 'ft/s', perSi: 1 / 0.3048, decimals: 2 },
  gap: { name: 'in', perSi: 1 / 0.0254, decimals: 1 },
  creep: { name: 'in/s', perSi: 1 / 0.0254, decimals: 1 },
  mass: { name: 'lb', perSi: 1 / 0.45359237, decimals: 0 },
};

const SI: Units = {
  name: 'SI',
  length: { name: 'm', perSi: 1, decimals: 3 },
  speed: { name: 'm/s', perSi: 1, decimals: 3 },
  gap: { name: 'cm', perSi: 100, decimals: 1 },
  creep: { name: 'cm/s', perSi: 100, decimals: 1 },
  mass: { name: 'kg', perSi: 1, decimals: 0 },
};

export function unitsOf(name: UnitName): Units {
  return name === 'SI' ? SI : FEET_INCHES;
}

/** Units that a page shows. The user can switch them: SI units, or feet and inches. */
export class ShownUnits {
  constructor(public name: UnitName) {}

  get units(): Units {
    return unitsOf(this.name);
  }

  toggle(): void {
    this.name = this.name === 'SI' ? 'ft-in' : 'SI';
  }
}

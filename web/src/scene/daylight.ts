import { Color, Vector3 } from 'three';
import { present } from '../basics/assert';
import type { LightCondition } from '../link/protocol';

/** Light of sun, Earth and sky. Directions are unit vectors in the scene; a colour includes the light's strength. */
export interface Daylight {
  readonly name: string;
  readonly toSun: Vector3;
  readonly nadir: Vector3;
  /** Colour times strength [lx], on the scale of the lamps' intensities in files: full sunlight is 4.1 lx. */
  readonly sun: Color;
  readonly earthshine: Color;
  /** Light from the half sphere above the orbiter (`above`), and from the half sphere below the orbiter (`below`). */
  readonly above: Color;
  readonly below: Color;
  /** Exposure when the light condition begins [photographic stops above the exposure for full sunlight]. */
  readonly exposure: number;
}

/** Strength of full sunlight. */
export const FULL_SUN = 4.1;

/** Returns the light of the condition with this name. */
export function daylightOf(conditions: readonly LightCondition[], name: string): Daylight {
  const condition = present(
    conditions.find((each) => each.name === name),
    `light ${name}`,
  );
  const { to_sun, nadir, sun, earthshine, sky } = condition;
  return {
    name,
    toSun: new Vector3(...to_sun).normalize(),
    nadir: new Vector3(...nadir).normalize(),
    sun: new Color(sun.colour).multiplyScalar(sun.strength),
    earthshine: new Color(earthshine.colour).multiplyScalar(earthshine.strength),
    above: new Color(sky.above).multiplyScalar(sky.strength),
    below: new Color(sky.below).multiplyScalar(sky.strength),
    exposure: condition.exposure,
  };
}

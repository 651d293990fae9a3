import { Color, Vector3 } from 'three';
import { present } from '../basics/assert';
import type { LightCondition } from '../link/protocol';

/** What comes from sun, Earth and sky: unit directions in the scene, and colours times strength. */
export interface Daylight {
  readonly name: string;
  readonly toSun: Vector3;
  readonly nadir: Vector3;
  /** Full sunlight has 4.1, which is the scale of a file's lamps. */
  readonly sun: Color;
  readonly earthshine: Color;
  /** From the half sphere above the orbiter and from the one below it. */
  readonly above: Color;
  readonly below: Color;
  /** Where the exposure begins [stops over that of full sunlight]. */
  readonly exposure: number;
}

/** Strength of full sunlight. */
export const FULL_SUN = 4.1;

/** The condition of a name as it is drawn. */
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

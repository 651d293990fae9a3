/** Estimates the light on a point of the scene, without shadows: the light that a camera there would see. */

import { type Color, Vector3 } from 'three';
import { clamp } from '../basics/clamp';
import type { Vec3 } from '../link/protocol';
import { type Daylight, FULL_SUN } from './daylight';
import { isSpot, type Lamp, lampPose } from './floodlights';

const [toLens, toLamp, at, along] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];

export class Lit {
  private daylight: Daylight | null = null;
  private on: ReadonlySet<string> = new Set();

  constructor(private readonly lamps: readonly Lamp[]) {}

  /** Sets the light of sun, Earth and sky, and the switches that are on. */
  set(daylight: Daylight, on: ReadonlySet<string>): void {
    this.daylight = daylight;
    this.on = on;
  }

  /** Direction to the sun in the scene; null at night. */
  get sun(): Vec3 | null {
    if (!this.daylight || strength(this.daylight.sun) === 0) return null;
    const { x, y, z } = this.daylight.toSun;
    return [x, y, z];
  }

  /**
   * Returns the light on the side of a small sphere that a camera sees, 0 to 1. At 1 the camera's initial exposure
   * shows it as bright as a sphere that full sunlight reaches from the side.
   */
  seen(place: Vec3, lens: Vec3): number {
    const { daylight } = this;
    if (!daylight) return 0;
    toLens.set(...lens).sub(at.set(...place));
    toLens.normalize();
    const sky = (strength(daylight.above) + strength(daylight.below)) / 2;
    const sun = strength(daylight.sun) * share(daylight.toSun);
    const earth = strength(daylight.earthshine) * share(daylight.nadir);
    const lamps = this.lamps.reduce((sum, lamp) => sum + this.fromLamp(lamp, place), 0);
    return clamp(((sky + sun + earth + lamps) * 2 ** daylight.exposure) / (FULL_SUN / 2), 0, 1);
  }

  private fromLamp(lamp: Lamp, place: Vec3): number {
    const { light } = lamp;
    if (!this.on.has(light.switch)) return 0;
    lampPose(lamp, at, along);
    toLamp.copy(at).sub(at.set(...place));
    const distance = toLamp.length();
    if (distance > light.reach || distance === 0) return 0;
    toLamp.divideScalar(distance);
    if (isSpot(light) && -toLamp.dot(along) < Math.cos(light.cone)) return 0;
    return (light.intensity * share(toLamp)) / Math.max(1, distance) ** 2;
  }
}

/** Share of a small sphere, as the camera sees it, that light from a direction reaches: 1 from behind the camera. */
function share(from: Vector3): number {
  return (1 + from.dot(toLens)) / 2;
}

function strength({ r, g, b }: Color): number {
  return Math.max(r, g, b);
}

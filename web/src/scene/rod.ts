/** Simplified bodies that cast the shadows of the low profile. */

import { Vector3 } from 'three';
import type { Body } from './bodies';

/** Length of the shortest body that casts a shadow [m]. */
const SHORTEST = 0.8;
const ABEAM = new Vector3(0, 1, 0);

/** Rod through the centre of a body's box, in the body's frame. */
export interface Rod {
  readonly body: Body;
  readonly from: Vector3;
  readonly to: Vector3;
  readonly radius: number;
}

/** Return the rod in a body's box, or an empty array for a body shorter than `SHORTEST`. */
export function rodOf(body: Body): Rod[] {
  const { min, max } = body.box();
  const size = new Vector3().subVectors(max, min);
  const long = [0, 1, 2].reduce((best, axis) => {
    return size.getComponent(axis) > size.getComponent(best) ? axis : best;
  }, 0);
  const radius = Math.min(size.x, size.y, size.z) * 0.6;
  if (size.getComponent(long) < SHORTEST) return [];
  const middle = new Vector3().addVectors(min, max).multiplyScalar(0.5);
  const [from, to] = [middle.clone(), middle.clone()];
  from.setComponent(long, min.getComponent(long) + radius / 2);
  to.setComponent(long, max.getComponent(long) - radius / 2);
  return [{ body, from, to, radius }];
}

/** Set two unit vectors normal to the sun's rays. */
export function acrossRays(toSun: Vector3, across: Vector3, up: Vector3): void {
  across.crossVectors(toSun, ABEAM).normalize();
  up.crossVectors(across, toSun);
}

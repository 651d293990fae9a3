/** A camera's view for given angles of its drives. `bodies/cameras.py` has the same formulas. */

import { Vector3 } from 'three';
import type { Camera, Vec3 } from '../link/protocol';

/** A camera's view, in its body's frame. */
export interface View {
  readonly position: Vec3;
  readonly boresight: Vec3;
  readonly up: Vec3;
  /** Horizontal field of view [rad]. */
  readonly angle: number;
}

const [ahead, right, up] = [new Vector3(), new Vector3(), new Vector3()];
const [level, boresight, lens] = [new Vector3(), new Vector3(), new Vector3()];

/** Returns the view for these drive angles: pan to the right, tilt upwards, horizontal field of view [rad]. */
export function viewOf(camera: Camera, [pan, tilt, angle]: Vec3): View {
  axes(camera);
  level.copy(ahead).multiplyScalar(Math.cos(pan)).addScaledVector(right, Math.sin(pan));
  boresight.copy(level).multiplyScalar(Math.cos(tilt)).addScaledVector(up, Math.sin(tilt));
  up.multiplyScalar(Math.cos(tilt)).addScaledVector(level, -Math.sin(tilt));
  const reach = camera.drive?.lens ?? 0;
  lens.set(...camera.boresight).normalize();
  lens.multiplyScalar(-reach).addScaledVector(boresight, reach);
  const [x, y, z] = camera.position;
  return {
    position: [x + lens.x, y + lens.y, z + lens.z],
    boresight: three(boresight),
    up: three(up),
    angle,
  };
}

/** Returns the initial angles of the drives. */
export function settingOf(camera: Camera): Vec3 {
  axes(camera);
  boresight.set(...camera.boresight);
  const [x, y, z] = [boresight.dot(ahead), boresight.dot(right), boresight.dot(up)];
  return [Math.atan2(y, x), Math.atan2(z, Math.hypot(x, y)), camera.field_of_view];
}

/** Computes three directions: ahead at zero pan and tilt, to the right, and up. */
function axes(camera: Camera): void {
  up.set(...camera.up).normalize();
  ahead
    .set(...(camera.drive?.zero ?? camera.boresight))
    .addScaledVector(up, -up.dot(ahead))
    .normalize();
  right.crossVectors(ahead, up);
}

function three({ x, y, z }: Vector3): Vec3 {
  return [x, y, z];
}

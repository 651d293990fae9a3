/** Shape of a bent boom, and the motion of all bodies behind it. */

import { Matrix4, Quaternion, Vector3 } from 'three';
import type { Vec3 } from '../link/protocol';

/** Displacement [m] and rotation vector [rad] of a part's end, relative to the straight part. */
export interface Bend {
  readonly displacement: Vec3;
  readonly rotation: Vec3;
}

/** Returns a bend multiplied by a factor. */
export function times({ displacement, rotation }: Bend, factor: number): Bend {
  const scaled = ([x, y, z]: Vec3): Vec3 => [factor * x, factor * y, factor * z];
  return { displacement: scaled(displacement), rotation: scaled(rotation) };
}

/** Returns the motion that takes bodies from their poses behind a straight part to those behind the bent one. */
export function motionOf({ displacement, rotation }: Bend, end: Vec3): Matrix4 {
  const vector = new Vector3(...rotation);
  const angle = vector.length();
  const turn = new Quaternion().setFromAxisAngle(
    angle > 0 ? vector.divideScalar(angle) : vector.set(1, 0, 0),
    angle,
  );
  const motion = new Matrix4().makeRotationFromQuaternion(turn);
  const tip = new Vector3(...end);
  const place = tip
    .clone()
    .add(new Vector3(...displacement))
    .sub(tip.clone().applyQuaternion(turn));
  return motion.setPosition(place);
}

const [along, sideways, turned, point, base] = Array.from({ length: 5 }, () => new Vector3()) as [
  Vector3,
  Vector3,
  Vector3,
  Vector3,
  Vector3,
];

/**
 * Bends points as a beam that is clamped at its beginning: the deflection is a cubic of the distance along the boom.
 * Points beyond the end move with the end.
 *
 * @param straight positions of the points while the boom is straight, three values for each [m].
 * @param bent output, of the same length.
 * @param end place of the straight boom's end; the boom begins at the origin [m].
 */
export function bendPoints(straight: ArrayLike<number>, bent: Float32Array, end: Vec3, bend: Bend): void {
  along.set(...end);
  const length = along.length();
  along.divideScalar(length);
  const displacement = new Vector3(...bend.displacement);
  const rotation = new Vector3(...bend.rotation);
  const twist = rotation.dot(along);
  const slope = rotation.clone().addScaledVector(along, -twist); // rotation without torsion
  sideways.crossVectors(slope, along).multiplyScalar(length);
  turned.crossVectors(along, displacement).divideScalar(length);
  for (let i = 0; i < bent.length; i += 3) {
    point.fromArray(straight, i);
    const s = Math.min(1, Math.max(0, point.dot(along) / length));
    const [h, k] = [s * s * (3 - 2 * s), s * s * (s - 1)];
    const [dh, dk] = [6 * s * (1 - s), s * (3 * s - 2)];
    base.copy(point).addScaledVector(along, -s * length); // from the boom's axis to the point
    const [rx, ry, rz] = [
      dh * turned.x + dk * slope.x + s * twist * along.x,
      dh * turned.y + dk * slope.y + s * twist * along.y,
      dh * turned.z + dk * slope.z + s * twist * along.z,
    ];
    bent[i] = point.x + h * displacement.x + k * sideways.x + ry * base.z - rz * base.y;
    bent[i + 1] = point.y + h * displacement.y + k * sideways.y + rz * base.x - rx * base.z;
    bent[i + 2] = point.z + h * displacement.z + k * sideways.z + rx * base.y - ry * base.x;
  }
}

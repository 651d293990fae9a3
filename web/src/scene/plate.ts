import { type BufferGeometry, ExtrudeGeometry, Matrix4, Shape as Outline, Vector2, Vector3 } from 'three';
import type { Plate } from '../link/protocol';

const [X, Y, Z] = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];

/** For each normal of a plate: the two axes of the outline's coordinates, and the axis of the thickness. */
const TURN = {
  x: new Matrix4().makeBasis(Y, Z, X),
  y: new Matrix4().makeBasis(X, Z, Y.clone().negate()),
  z: new Matrix4().makeBasis(X, Y, Z),
};

/** Make a flat outline with thickness and bevelled rims. */
export function plate({ outline, thickness, bevel, normal }: Plate): BufferGeometry {
  const geometry = new ExtrudeGeometry(new Outline(outline.map(([a, b]) => new Vector2(a, b))), {
    depth: thickness - 2 * bevel,
    bevelEnabled: bevel > 0,
    bevelThickness: bevel,
    bevelSize: bevel,
    bevelOffset: -bevel,
    bevelSegments: 2,
  });
  return geometry.translate(0, 0, bevel - thickness / 2).applyMatrix4(TURN[normal]);
}

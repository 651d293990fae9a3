import { ExtrudeGeometry, Matrix4, Shape as Outline, Vector2, Vector3 } from 'three';
import type { Plate } from '../link/protocol';
import { Surface } from './surface';

const X = new Vector3(1, 0, 0);
const Y = new Vector3(0, 1, 0);
const Z = new Vector3(0, 0, 1);

/** For each normal of a plate: the two axes of the outline's coordinates, and the axis of the thickness. */
const TURN = {
  x: new Matrix4().makeBasis(Y, Z, X),
  y: new Matrix4().makeBasis(X, Z, Y.clone().negate()),
  z: new Matrix4().makeBasis(X, Y, Z),
};

/** A flat outline with thickness and bevelled rims. */
export function plate(shape: Plate): Surface {
  const geometry = new ExtrudeGeometry(new Outline(shape.outline.map(([a, b]) => new Vector2(a, b))), {
    depth: shape.thickness - 2 * shape.bevel,
    bevelEnabled: shape.bevel > 0,
    bevelThickness: shape.bevel,
    bevelSize: shape.bevel,
    bevelOffset: -shape.bevel,
    bevelSegments: 2,
  });
  geometry.translate(0, 0, shape.bevel - shape.thickness / 2);
  const flat = new Surface();
  const count = geometry.getAttribute('position').count;
  const { position, normal, uv } = geometry.attributes;
  if (position && normal && uv) {
    for (let i = 0; i < count; i++) {
      flat.vertex(
        new Vector3().fromBufferAttribute(position, i),
        new Vector3().fromBufferAttribute(normal, i),
        uv.getX(i),
        uv.getY(i),
      );
    }
  }
  for (let i = 0; i < count; i += 3) flat.triangle(i, i + 1, i + 2);
  geometry.dispose();
  const surface = new Surface();
  surface.append(flat, TURN[shape.normal]);
  return surface;
}

import { type BufferGeometry, Vector3 } from 'three';
import type { Vec2 } from '../link/protocol';

const [position, normal] = [new Vector3(), new Vector3()];

/**
 * Set the texture coordinates [m] of a geometry, which three counts from 0 to 1, so that patterns have their own size.
 * `at` returns them for a vertex, from its position [m], its normal, three's u and v, and its number.
 */
export function textured(
  geometry: BufferGeometry,
  at: (position: Vector3, normal: Vector3, u: number, v: number, i: number) => Vec2,
): BufferGeometry {
  const places = geometry.getAttribute('position');
  const normals = geometry.getAttribute('normal');
  const uvs = geometry.getAttribute('uv');
  for (let i = 0; i < uvs.count; i++) {
    position.fromBufferAttribute(places, i);
    normal.fromBufferAttribute(normals, i);
    uvs.setXY(i, ...at(position, normal, uvs.getX(i), uvs.getY(i), i));
  }
  return geometry;
}

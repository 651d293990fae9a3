/** Surfaces of shapes as the page draws them, and their volumes. */

import { Matrix4, Vector3 } from 'three';
import type { Quality } from '../src/scene/drawn';
import { geometriesOf, type Leaf } from '../src/scene/shapes';
import { Surface } from '../src/scene/surface';

/** Returns the surface of a shape, relative to its own origin. */
export function surfaceOf(shape: Leaf, quality: Quality): Surface {
  const surface = new Surface();
  for (const geometry of geometriesOf(shape, quality)) surface.append(geometry, new Matrix4());
  return surface;
}

/** Returns the volume of a closed surface; negative if its triangles face inwards. */
export function volume({ positions, indices }: Surface): number {
  const corner = (i: number) => new Vector3().fromArray(positions, 3 * (indices[i] ?? 0));
  let sum = 0;
  for (let i = 0; i < indices.length; i += 3) sum += corner(i).dot(corner(i + 1).cross(corner(i + 2))) / 6;
  return sum;
}

/** Sizes of shapes as the page draws them; `tests/scene/test_page_surfaces.py` compares them with the package's. */

import { Box3, Vector3 } from 'three';
import type { Quality } from '../src/scene/drawn';
import type { Leaf } from '../src/scene/shapes';
import { surfaceOf, volume } from './surfaces';

/** Returns the volume [m^3] and the bounds [m] of each shape's surface. */
export function measured(shapes: readonly Leaf[], quality: Quality) {
  return shapes.map((shape) => {
    const surface = surfaceOf(shape, quality);
    const corners = surface.indices.map((i) => new Vector3().fromArray(surface.positions, 3 * i));
    const { min, max } = new Box3().setFromPoints(corners);
    return { volume: volume(surface), low: min.toArray(), high: max.toArray() };
  });
}

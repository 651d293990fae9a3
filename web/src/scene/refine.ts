import { Vector3 } from 'three';
import type { Surface } from './surface';

/** Greatest length of an edge along a boom [m], so that the drawn boom can bend. */
const STEP = 0.8;

const [first, second] = [new Vector3(), new Vector3()];

/**
 * Splits all triangles of a surface until no edge is longer than `STEP` along a direction. An edge that two triangles
 * share is split at the same points in both, so that the surface stays closed. `colours`: three values for each vertex.
 */
export function refine(surface: Surface, colours: number[], along: Vector3): void {
  const { positions, normals, uvs, indices } = surface;
  const middles = new Map<string, number>();
  const at = (i: number) => along.dot(first.fromArray(positions, 3 * i));
  const middle = (a: number, b: number): number => {
    const name = a < b ? `${a} ${b}` : `${b} ${a}`;
    const known = middles.get(name);
    if (known !== undefined) return known;
    const half = (values: readonly number[], i: number, j: number) =>
      ((values[i] ?? 0) + (values[j] ?? 0)) / 2;
    const place = first
      .fromArray(positions, 3 * a)
      .add(second.fromArray(positions, 3 * b))
      .multiplyScalar(0.5)
      .clone();
    const normal = first
      .fromArray(normals, 3 * a)
      .add(second.fromArray(normals, 3 * b))
      .normalize();
    const made = surface.vertex(place, normal, half(uvs, 2 * a, 2 * b), half(uvs, 2 * a + 1, 2 * b + 1));
    for (let i = 0; i < 3; i++) colours.push(half(colours, 3 * a + i, 3 * b + i));
    middles.set(name, made);
    return made;
  };
  const waiting: [number, number, number][] = [];
  for (let i = 0; i < indices.length; i += 3)
    waiting.push([indices[i] ?? 0, indices[i + 1] ?? 0, indices[i + 2] ?? 0]);
  indices.length = 0;
  for (let triangle = waiting.pop(); triangle; triangle = waiting.pop()) {
    const corners = triangle;
    const lengths = corners.map((a, i) => Math.abs(at(a) - at(corners[(i + 1) % 3] ?? 0)));
    const longest = lengths.indexOf(Math.max(...lengths));
    const [a, b, c] = [0, 1, 2].map((i) => corners[(longest + i) % 3] ?? 0) as [number, number, number];
    if ((lengths[longest] ?? 0) <= STEP) surface.triangle(a, b, c);
    else {
      const m = middle(a, b);
      waiting.push([a, m, c], [m, b, c]);
    }
  }
}

import { Vector3 } from 'three';
import { present } from '../basics/assert';
import type { Loft, Section } from '../link/protocol';
import { Surface } from './surface';

const edgeAlong = new Vector3();
const edgeRound = new Vector3();

/** Make the surface over a loft's sections, closed at both ends, with `segments` points around each section. */
export function loft(shape: Loft, segments: number): Surface {
  const rings = shape.sections.map((section) => ringOf(section, segments));
  const width = 2 * Math.PI * Math.max(...shape.sections.map((section) => section.half_width));
  const surface = new Surface();
  rings.forEach((ring, i) => {
    ring.forEach((position, k) => {
      surface.vertex(position, normalAt(rings, i, k), position.x, (width * k) / segments);
      if (i === 0 || k === 0) return;
      const b = i * (segments + 1) + k - 1;
      const a = b - (segments + 1);
      surface.triangle(a, a + 1, b);
      surface.triangle(b, a + 1, b + 1);
    });
  });
  cap(surface, present(rings[0], 'section'), -1);
  cap(surface, present(rings.at(-1), 'section'), 1);
  return surface;
}

/** Return the points of a section, from the lowest one over starboard, top and port; the last one repeats the first. */
function ringOf(section: Section, segments: number): Vector3[] {
  const ring: Vector3[] = [];
  for (let k = 0; k <= segments; k++) {
    const angle = (2 * Math.PI * (k % segments)) / segments - Math.PI / 2;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const [upper, lower] = section.exponents;
    const power = 2 / (s > 0 ? upper : lower);
    const height = s > 0 ? section.top - section.middle : section.middle - section.bottom;
    const y = section.half_width * Math.sign(c) * Math.abs(c) ** power;
    ring.push(new Vector3(section.x, y, section.middle + height * Math.sign(s) * Math.abs(s) ** power));
  }
  return ring;
}

/** Return the outward unit normal at a point of the surface, from the neighbouring points. */
function normalAt(rings: readonly Vector3[][], i: number, k: number): Vector3 {
  const ring = present(rings[i], 'section');
  const segments = ring.length - 1;
  const before = present(rings[Math.max(i - 1, 0)]?.[k], 'section');
  const after = present(rings[Math.min(i + 1, rings.length - 1)]?.[k], 'section');
  edgeAlong.subVectors(after, before);
  edgeRound.subVectors(
    present(ring[(k + 1) % segments], 'section'),
    present(ring[(k + segments - 1) % segments], 'section'),
  );
  return new Vector3().crossVectors(edgeRound, edgeAlong).normalize();
}

function cap(surface: Surface, ring: readonly Vector3[], side: 1 | -1): void {
  const normal = new Vector3(side, 0, 0);
  const first = surface.positions.length / 3;
  for (const position of ring) surface.vertex(position, normal, position.y, position.z);
  for (let k = 2; k < ring.length; k++) {
    if (side > 0) surface.triangle(first, first + k - 1, first + k);
    else surface.triangle(first, first + k, first + k - 1);
  }
}

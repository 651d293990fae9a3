import { type BufferGeometry, Vector3 } from 'three';
import { LoftGeometry } from 'three/addons/geometries/LoftGeometry.js';
import type { Loft, Section } from '../link/protocol';
import { textured } from './textured';

/** Make the skin over a loft's sections, closed at both ends, with `points` points around each section. */
export function loft({ sections }: Loft, points: number): BufferGeometry {
  const width = 2 * Math.PI * Math.max(...sections.map((section) => section.half_width));
  const walls = sections.length * (points + 1);
  const rings = sections.map((section) => ringOf(section, points));
  return textured(new LoftGeometry(rings, { capStart: true, capEnd: true }), ({ x, y, z }, _, __, ___, i) =>
    i < walls ? [x, (width * (i % (points + 1))) / points] : [y, z],
  );
}

/** Return the points of a section, from the lowest one over starboard, top and port. */
function ringOf(section: Section, points: number): Vector3[] {
  return Array.from({ length: points }, (_, k) => {
    const angle = (2 * Math.PI * k) / points - Math.PI / 2;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const [upper, lower] = section.exponents;
    const power = 2 / (s > 0 ? upper : lower);
    const height = s > 0 ? section.top - section.middle : section.middle - section.bottom;
    const y = section.half_width * Math.sign(c) * Math.abs(c) ** power;
    return new Vector3(section.x, y, section.middle + height * Math.sign(s) * Math.abs(s) ** power);
  });
}

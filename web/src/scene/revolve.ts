import { Vector3 } from 'three';
import { present } from '../basics/assert';
import type { Axis, Vec2 } from '../link/protocol';
import { Surface } from './surface';

/** Smooth part of a profile: points (position along the axis, distance from it), with the outside on the left. */
export type Strip = readonly Vec2[];

const FULL = 2 * Math.PI - 1e-3;

/** Make the surface that a profile sweeps about an axis. Neighbouring strips meet at a sharp edge. */
export function revolve(
  strips: readonly Strip[],
  axis: Axis,
  start: number,
  sweep: number,
  segments: number,
): Surface {
  const surface = new Surface();
  for (const strip of strips) sweepStrip(surface, strip, axis, start, sweep, segments);
  if (sweep < FULL) {
    const outline = strips.flatMap((strip) => strip.slice(1));
    closeEnd(surface, outline, axis, start, -1);
    closeEnd(surface, outline, axis, start + sweep, 1);
  }
  return surface;
}

/**
 * Return a point or direction in the body's x, y, z. `along`, `away` and `round` are its components along the axis,
 * away from the axis and round the axis. The directions of the last two are those at `angle` about the axis [rad].
 */
function around(axis: Axis, angle: number, along: number, away: number, round: number): Vector3 {
  const p = away * Math.cos(angle) - round * Math.sin(angle);
  const q = away * Math.sin(angle) + round * Math.cos(angle);
  if (axis === 'x') return new Vector3(along, p, q);
  return axis === 'y' ? new Vector3(q, along, p) : new Vector3(p, q, along);
}

function sweepStrip(
  surface: Surface,
  strip: Strip,
  axis: Axis,
  start: number,
  sweep: number,
  segments: number,
): void {
  const across = segments + 1;
  const first = surface.positions.length / 3;
  const widest = Math.max(...strip.map(([, away]) => away));
  const [begin, end] = [present(strip[0], 'profile'), present(strip.at(-1), 'profile')];
  const flat = Math.abs(end[0] - begin[0]) < 1e-9;
  let length = 0;
  strip.forEach(([along, away], i) => {
    const before = strip[i - 1];
    if (before) length += Math.hypot(along - before[0], away - before[1]);
    const [nAlong, nAway] = normalAt(strip, i);
    for (let k = 0; k < across; k++) {
      const angle = start + (sweep * k) / segments;
      const position = around(axis, angle, along, away, 0);
      const [u, v] = flat
        ? [away * Math.cos(angle), away * Math.sin(angle)]
        : [begin[0] + length, widest * angle];
      surface.vertex(position, around(axis, angle, nAlong, nAway, 0), u, v);
    }
    if (!before) return;
    for (let k = 0; k < segments; k++) {
      const b = first + i * across + k;
      const a = b - across;
      if (before[1] > 1e-9) surface.triangle(a, a + 1, b);
      if (away > 1e-9) surface.triangle(b, a + 1, b + 1);
    }
  });
}

/** Return the outward unit normal (along, away) at point i of a strip. A strip is closed if its ends coincide. */
function normalAt(strip: Strip, i: number): Vec2 {
  const last = strip.length - 1;
  const [begin, end] = [present(strip[0], 'profile'), present(strip[last], 'profile')];
  const closed = Math.hypot(begin[0] - end[0], begin[1] - end[1]) < 1e-9;
  const before = strip[i > 0 ? i - 1 : closed ? last - 1 : 0];
  const after = strip[i < last ? i + 1 : closed ? 1 : last];
  const [from, to] = [present(before, 'profile'), present(after, 'profile')];
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  return [(from[1] - to[1]) / length, (to[0] - from[0]) / length];
}

/** Add the flat face at one end of a partial turn. The outline must be convex. */
function closeEnd(surface: Surface, outline: Strip, axis: Axis, angle: number, side: 1 | -1): void {
  const first = surface.positions.length / 3;
  const normal = around(axis, angle, 0, 0, side);
  for (const [along, away] of outline)
    surface.vertex(around(axis, angle, along, away, 0), normal, along, away);
  for (let i = 2; i < outline.length; i++) {
    if (side > 0) surface.triangle(first, first + i, first + i - 1);
    else surface.triangle(first, first + i - 1, first + i);
  }
}

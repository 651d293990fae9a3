import {
  type BufferGeometry,
  LatheGeometry,
  Matrix4,
  Shape as Outline,
  ShapeGeometry,
  TorusGeometry,
  Vector2,
  Vector3,
} from 'three';
import { present } from '../basics/assert';
import type { Axis, Ring, Vec2 } from '../link/protocol';
import { textured } from './textured';

/** Points of a profile: position along the axis, and distance from it [m], with the outside on the left. */
export type Profile = readonly Vec2[];

/** Angles about an axis [rad]. */
export interface Turn {
  readonly start: number;
  readonly sweep: number;
}

export const WHOLE: Turn = { start: 0, sweep: 2 * Math.PI };
const FULL = WHOLE.sweep - 1e-3;

const [X, Y, Z] = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];
/** For each axis: itself, and the directions at 0 and 90 degrees about it. */
const AXES: Record<Axis, readonly [Vector3, Vector3, Vector3]> = { x: [X, Y, Z], y: [Y, Z, X], z: [Z, X, Y] };

/** Make the flat rings and conical walls that the edges of a profile sweep. */
export function revolved(profile: Profile, axis: Axis, turn: Turn, segments: number): BufferGeometry[] {
  const { start, sweep } = turn;
  const edges = profile.slice(1).map((to, i) => [present(profile[i], 'profile'), to] as const);
  const points = edges.flat(); // each corner twice, so that the edges stay sharp
  const outline = points.map(([along, away]) => new Vector2(away, along));
  const lathe = new LatheGeometry(outline, segments, start, sweep);
  textured(lathe, ({ x, z }, _, u, __, i) => {
    const n = i % points.length;
    const [from, to] = present(edges[n >> 1], 'edge');
    if (from[0] === to[0]) return [z, x];
    const length = n % 2 === 0 ? 0 : Math.hypot(to[0] - from[0], to[1] - from[1]);
    return [from[0] + length, Math.max(from[1], to[1]) * (start + sweep * u)];
  });
  const [along, first, second] = AXES[axis];
  lathe.applyMatrix4(new Matrix4().makeBasis(second, along, first));
  return [lathe, ...ends(profile.slice(1), axis, turn)];
}

/** Make a bent bar with `points` sides, which look round. */
export function bent(shape: Ring, points: number, segments: number): BufferGeometry[] {
  const { radius, bar, axis, start, sweep } = shape;
  const torus = new TorusGeometry(radius, bar, points, segments, sweep).rotateZ(start);
  textured(torus, ({ x, y }) => [x, y]);
  const [along, first, second] = AXES[axis];
  torus.applyMatrix4(new Matrix4().makeBasis(first, second, along));
  const outline = Array.from({ length: points }, (_, i): Vec2 => {
    const angle = (2 * Math.PI * i) / points;
    return [bar * Math.sin(angle), radius + bar * Math.cos(angle)];
  });
  return [torus, ...ends(outline, axis, shape)];
}

/** Make the flat faces at both ends of a partial turn of a closed outline; none if the turn is whole. */
function ends(outline: Profile, axis: Axis, { start, sweep }: Turn): BufferGeometry[] {
  if (sweep >= FULL) return [];
  const flat = new Outline(outline.map(([along, away]) => new Vector2(along, away)));
  const [along, first, second] = AXES[axis];
  return [-1, 1].map((side) => {
    const angle = side > 0 ? start + sweep : start;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const away = first.clone().multiplyScalar(c).addScaledVector(second, s);
    const round = second.clone().multiplyScalar(c).addScaledVector(first, -s).multiplyScalar(side);
    const face = new ShapeGeometry(flat);
    if (side < 0) face.index?.array.reverse(); // the motion is a reflection
    return face.applyMatrix4(new Matrix4().makeBasis(along, away, round));
  });
}

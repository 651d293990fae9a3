import { Vector3 } from 'three';
import { assertUnreachable } from '../basics/assert';
import type {
  Box,
  Cylinder,
  Group,
  Hexahedron,
  Light,
  Ring,
  Shape,
  Shell,
  Sphere,
  Vec2,
} from '../link/protocol';
import type { Quality } from './drawn';
import { loft } from './loft';
import { plate } from './plate';
import { revolve, type Strip } from './revolve';
import { Surface } from './surface';

/**
 * Pairs of a radius [m] and a number of sides. In the low profile, a circle has the sides of the first pair with a
 * larger radius than its own, or `MOST` sides if there is none.
 */
const SIDES = [
  [0.045, 8],
  [0.16, 16],
  [0.3, 20],
  [1, 24],
] as const;
const MOST = 32;
/** Fewest sides of a sphere: the ball of a target is small, but an operator aims at it from near. */
const ROUNDEST = 12;
/** Fewest sides of a ring: the wrist camera sees the rings of targets and fixtures from near, and there are only a few. */
const ROUND_RING = 40;
const TURN = 2 * Math.PI;

/** Make the surface of a shape, relative to its own origin. */
export function surfaceOf(shape: Exclude<Shape, Group>, quality: Quality): Surface {
  switch (shape.kind) {
    case 'box':
      return box(shape);
    case 'cylinder':
      return cylinder(shape, quality);
    case 'shell':
      return shell(shape, quality);
    case 'ring':
      return ring(shape, quality);
    case 'sphere':
      return sphere(shape, quality);
    case 'plate':
      return plate(shape);
    case 'loft':
      return loft(shape, quality === 'full' ? 64 : 24);
    case 'hexahedron':
      return hexahedron(shape);
    case 'light':
      return face(shape, quality);
    default:
      return assertUnreachable(shape);
  }
}

/** Return the number of sides with which a circle of this radius [m] is drawn. */
function sides(radius: number, quality: Quality): number {
  if (quality === 'low') return SIDES.find(([below]) => radius < below)?.[1] ?? MOST;
  return Math.round(Math.min(96, 24 + 60 * radius));
}

function box({ size }: Box): Surface {
  const surface = new Surface();
  const half = new Vector3(...size).multiplyScalar(0.5);
  for (let axis = 0; axis < 3; axis++) {
    for (const side of [1, -1]) {
      const [p, q] = [(axis + 1) % 3, (axis + 2) % 3];
      const normal = new Vector3().setComponent(axis, side);
      const corners = [
        [-1, -1],
        [1, -1],
        [1, 1],
        [-1, 1],
      ] as const;
      const [a, b, c, d] = corners.map(([s, t]) => {
        const [u, v] = [s * half.getComponent(p), t * half.getComponent(q)];
        const corner = new Vector3().setComponent(axis, side * half.getComponent(axis));
        return surface.vertex(corner.setComponent(p, u).setComponent(q, v), normal, u, v);
      }) as [number, number, number, number];
      surface.indices.push(...(side > 0 ? [a, b, c, a, c, d] : [a, c, b, a, d, c]));
    }
  }
  return surface;
}

/** Vertices (from 0) of the faces a to f of a hexahedron, counter-clockwise as seen from outside. */
const RIMS = [
  [0, 1, 5, 4],
  [0, 2, 3, 1],
  [0, 4, 6, 2],
  [1, 3, 7, 5],
  [4, 5, 7, 6],
  [2, 6, 7, 3],
] as const;

function hexahedron({ vertices }: Hexahedron): Surface {
  const surface = new Surface();
  const corner = (i: number): Vector3 => new Vector3(...(vertices[i] ?? [0, 0, 0]));
  for (const rim of RIMS) {
    const [p, q, r, s] = rim;
    const along = corner(q).sub(corner(p)).normalize();
    const normal = corner(r)
      .sub(corner(p))
      .cross(corner(s).sub(corner(q)))
      .normalize();
    const across = normal.clone().cross(along);
    const [a, b, c, d] = rim.map((i) => {
      const point = corner(i);
      return surface.vertex(point, normal, point.dot(along), point.dot(across));
    }) as [number, number, number, number];
    surface.indices.push(a, b, c, a, c, d);
  }
  return surface;
}

function cylinder(shape: Cylinder, quality: Quality): Surface {
  const [half, radius, end] = [shape.length / 2, shape.radius, shape.radius_end ?? shape.radius];
  const corners: Strip = [
    [-half, 0],
    [-half, radius],
    [half, end],
    [half, 0],
  ];
  return revolve(edges(corners), shape.axis, 0, TURN, sides(Math.max(radius, end), quality));
}

/** Make the face of a lamp, visible from its front. */
function face({ radius }: Light, quality: Quality): Surface {
  const profile: Strip = [
    [0, radius],
    [0, 0],
  ];
  return revolve([profile], 'x', 0, TURN, sides(radius, quality));
}

function shell(shape: Shell, quality: Quality): Surface {
  const { radius, thickness } = shape;
  const [half, end] = [shape.length / 2, shape.radius_end ?? radius];
  const outline: Strip = [
    [-half, radius],
    [half, end],
    [half, end - thickness],
    [-half, radius - thickness],
    [-half, radius],
  ];
  const segments = part(shape.sweep, Math.max(radius, end), quality);
  return revolve(edges(outline), shape.axis, shape.start, shape.sweep, segments);
}

function ring(shape: Ring, quality: Quality): Surface {
  const points = quality === 'full' ? 12 : 4;
  const profile = steps(points, (t): Vec2 => {
    const angle = TURN * t;
    return [shape.bar * Math.sin(angle), shape.radius + shape.bar * Math.cos(angle)];
  });
  const segments = part(shape.sweep, shape.radius, quality, ROUND_RING);
  return revolve([profile], shape.axis, shape.start, shape.sweep, segments);
}

function sphere({ radius }: Sphere, quality: Quality): Surface {
  const round = Math.max(ROUNDEST, sides(radius, quality));
  const profile = steps(round / 2, (t): Vec2 => {
    return [-radius * Math.cos(Math.PI * t), radius * Math.sin(Math.PI * t)];
  });
  return revolve([profile], 'x', 0, TURN, round);
}

/** Return the number of sides of a partial turn; `least`: fewest sides of a whole turn. */
function part(sweep: number, radius: number, quality: Quality, least = 0): number {
  return Math.max(1, Math.ceil((Math.max(sides(radius, quality), least) * sweep) / TURN));
}

/** Return one strip for each edge of an angular profile, so that the corners stay sharp. */
function edges(corners: Strip): Strip[] {
  return corners.slice(1).map((corner, i) => [corners[i] ?? corner, corner]);
}

/** Return the values of a curve at t = 0, 1/n … 1. */
function steps(n: number, curve: (t: number) => Vec2): Strip {
  return Array.from({ length: Math.ceil(n) + 1 }, (_, i) => curve(i / Math.ceil(n)));
}

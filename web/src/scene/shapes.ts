/** Shapes as geometries of three, with the numbers of sides of both drawing profiles. */

import { BoxGeometry, type BufferGeometry, SphereGeometry, Vector3 } from 'three';
import { assertUnreachable, present } from '../basics/assert';
import type { Box, Cylinder, Group, Hexahedron, Light, Shape, Shell, Sphere } from '../link/protocol';
import type { Quality } from './drawn';
import { loft } from './loft';
import { plate } from './plate';
import { bent, revolved, WHOLE } from './revolved';
import { textured } from './textured';

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

/** A shape that is not a group. */
export type Leaf = Exclude<Shape, Group>;

/** Make the geometries that together are the surface of a shape, relative to its own origin. */
export function geometriesOf(shape: Leaf, quality: Quality): BufferGeometry[] {
  switch (shape.kind) {
    case 'box':
      return [box(shape)];
    case 'cylinder':
      return cylinder(shape, quality);
    case 'shell':
      return shell(shape, quality);
    case 'ring': {
      const segments = part(shape.sweep, shape.radius, quality, ROUND_RING);
      return bent(shape, quality === 'full' ? 12 : 4, segments);
    }
    case 'sphere':
      return [sphere(shape, quality)];
    case 'plate':
      return [plate(shape)];
    case 'loft':
      return [loft(shape, quality === 'full' ? 64 : 24)];
    case 'hexahedron':
      return [hexahedron(shape)];
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

/** Return the number of sides of a partial turn; `least`: fewest sides of a whole turn. */
function part(sweep: number, radius: number, quality: Quality, least = 0): number {
  return Math.max(1, Math.ceil((Math.max(sides(radius, quality), least) * sweep) / WHOLE.sweep));
}

function box({ size }: Box): BufferGeometry {
  return textured(new BoxGeometry(...size), (position, normal) => {
    const axis = [0, 1, 2].findIndex((i) => normal.getComponent(i) !== 0);
    return [position.getComponent((axis + 1) % 3), position.getComponent((axis + 2) % 3)];
  });
}

/** Number of a hexahedron's vertex, counted from 0, that differs from vertex 0 only along x, y or z. */
const STEPS = [2, 4, 1] as const;

/** Move the corners of a box to a hexahedron's vertices. Patterns begin along one edge of each face. */
function hexahedron({ vertices }: Hexahedron): BufferGeometry {
  const geometry = new BoxGeometry(1, 1, 1);
  const [position, facing] = [geometry.getAttribute('position'), geometry.getAttribute('normal').clone()];
  const vertex = (number: number) => new Vector3(...present(vertices[number], 'vertex'));
  for (let i = 0; i < position.count; i++) {
    const number = STEPS.reduce(
      (sum, step, axis) => sum + (position.getComponent(i, axis) > 0 ? step : 0),
      0,
    );
    position.setXYZ(i, ...vertex(number).toArray());
  }
  geometry.computeVertexNormals();
  return textured(geometry, (point, normal, _, __, i) => {
    const axis = [0, 1, 2].find((each) => facing.getComponent(i, each) !== 0) ?? 0;
    const outer = facing.getComponent(i, axis) > 0;
    const first = outer ? (STEPS[axis] ?? 0) : 0;
    const next = first + (STEPS[(axis + (outer ? 1 : 2)) % 3] ?? 0);
    const along = vertex(next).sub(vertex(first)).normalize();
    return [point.dot(along), point.dot(normal.clone().cross(along))];
  });
}

function cylinder(shape: Cylinder, quality: Quality): BufferGeometry[] {
  const [half, radius, end] = [shape.length / 2, shape.radius, shape.radius_end ?? shape.radius];
  const profile = [
    [-half, 0],
    [-half, radius],
    [half, end],
    [half, 0],
  ] as const;
  return revolved(profile, shape.axis, WHOLE, sides(Math.max(radius, end), quality));
}

/** Make the face of a lamp, visible from its front. */
function face({ radius }: Light, quality: Quality): BufferGeometry[] {
  const profile = [
    [0, radius],
    [0, 0],
  ] as const;
  return revolved(profile, 'x', WHOLE, sides(radius, quality));
}

function shell(shape: Shell, quality: Quality): BufferGeometry[] {
  const { radius, thickness } = shape;
  const [half, end] = [shape.length / 2, shape.radius_end ?? radius];
  const profile = [
    [-half, radius],
    [half, end],
    [half, end - thickness],
    [-half, radius - thickness],
    [-half, radius],
  ] as const;
  return revolved(profile, shape.axis, shape, part(shape.sweep, Math.max(radius, end), quality));
}

function sphere({ radius }: Sphere, quality: Quality): BufferGeometry {
  const round = Math.max(ROUNDEST, sides(radius, quality));
  const geometry = new SphereGeometry(radius, round, Math.ceil(round / 2)).rotateZ(Math.PI / 2);
  return textured(geometry, (_, __, u, v) => [radius * Math.PI * v, radius * WHOLE.sweep * u]);
}

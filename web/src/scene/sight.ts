/** Computes what a camera sees: points of the scene that are in its picture and that nothing hides. */

import { type Intersection, type Mesh, type PerspectiveCamera, Raycaster, Vector3 } from 'three';
import type { Camera, FreeEye, Vec3 } from '../link/protocol';
import type { Body } from './bodies';
import type { Cameras } from './cameras';
import { ASPECT } from './drawn';

/** Sample points of a picture: coordinates to the right and upwards, each in [-1, 1]. */
const SPREAD = [-0.75, -0.25, 0.25, 0.75].flatMap((x) => [-0.7, 0, 0.7].map((y) => [x, y] as const));
/** Range of visibility [m]. */
const FARTHEST = 400;
/** Sample points of a line, as fractions of its length. */
const ALONG = [0.5, 0.2, 0.8] as const;
/** An obstacle less than this distance in front of a point counts as the surface to which the point belongs [m]. */
const OWN = 0.02;

/** Steps of an eye's coordinates: 1e-5 m, and as many of a direction. */
const STEPS = 1e5;

const ray = new Raycaster();
const [lens, way, axis] = [new Vector3(), new Vector3(), new Vector3()];

export class Sight {
  private readonly meshes: Mesh[];
  private readonly samples = new Map<string, readonly Vector3[]>();

  constructor(
    private readonly cameras: Cameras,
    private readonly bodies: readonly Body[],
  ) {
    this.meshes = bodies.flatMap(({ plain }) => plain);
  }

  /**
   * Returns the bodies at sample points of the picture, each with the fraction of the picture that it fills. A near
   * body need not be entirely in the picture.
   */
  ahead(camera: Camera): ReadonlyMap<string, number> {
    const seen = this.cameras.at(camera.name, ASPECT);
    const found = new Map<string, number>();
    for (const [x, y] of SPREAD) {
      lens.setFromMatrixPosition(seen.matrixWorld);
      way.set(x, y, 0.5).unproject(seen).sub(lens).normalize();
      const [first] = this.cast(seen, FARTHEST);
      const name = first?.object.parent?.name;
      if (name !== undefined) found.set(name, (found.get(name) ?? 0) + 1 / SPREAD.length);
    }
    found.delete(camera.body);
    return found;
  }

  /** Returns whether the camera sees any part of a line of the scene; its ends do not count, as they are on bodies. */
  line(camera: Camera, a: Vec3, b: Vec3): boolean {
    return ALONG.some((part) => this.point(camera, between(a, b, part)));
  }

  /** Returns two values: whether no body hides the line near its first end, and near its second end. */
  ends(camera: Camera, a: Vec3, b: Vec3): readonly [boolean, boolean] {
    const [, ...near] = ALONG;
    const [first = false, last = false] = near.map((part) => this.clear(camera, between(a, b, part), null));
    return [first, last];
  }

  /**
   * Returns the fraction of a body that the camera sees. Sample points are the middle of the body's box and the
   * middles of the box's faces.
   */
  visible(camera: Camera, name: string): number {
    const body = this.bodies.find(({ group }) => group.name === name);
    if (!body || camera.body === name) return 0;
    const samples = this.samplesOf(body);
    const seen = samples.filter((sample) => {
      const { x, y, z } = way.copy(sample).applyMatrix4(body.group.matrixWorld);
      const place: Vec3 = [x, y, z];
      return this.within(camera, place) && this.clear(camera, place, body);
    });
    return samples.length > 0 ? seen.length / samples.length : 0;
  }

  /** Returns whether a point of the scene is in the camera's picture and not hidden. */
  point(camera: Camera, place: Vec3): boolean {
    return this.within(camera, place) && this.clear(camera, place, null);
  }

  /** Returns the width of the camera's picture at a distance from the lens [m]. */
  width({ name }: Camera, distance: number): number {
    return 2 * distance * Math.tan(this.cameras.setting(name)[2] / 2);
  }

  /** Position of the camera's lens in the scene. */
  lens({ name }: Camera): Vec3 {
    const { x, y, z } = lens.setFromMatrixPosition(this.cameras.at(name, ASPECT).matrixWorld);
    return [x, y, z];
  }

  /** Direction of the camera's view in the scene. */
  direction({ name }: Camera): Vec3 {
    const { x, y, z } = axis.set(0, 0, -1).transformDirection(this.cameras.at(name, ASPECT).matrixWorld);
    return [x, y, z];
  }

  /** Eye of the camera in the scene, as the station takes it; rounded, so that it changes only if the view does. */
  eye({ name }: Camera): FreeEye {
    const { matrixWorld } = this.cameras.at(name, ASPECT);
    const rounded = ({ x, y, z }: Vector3): Vec3 => [round(x), round(y), round(z)];
    return {
      position: rounded(lens.setFromMatrixPosition(matrixWorld)),
      ahead: rounded(axis.set(0, 0, -1).transformDirection(matrixWorld)),
      up: rounded(way.set(0, 1, 0).transformDirection(matrixWorld)),
      field_of_view: this.cameras.setting(name)[2],
    };
  }

  private within({ name, pane }: Camera, place: Vec3): boolean {
    if (!this.cameras.project(name, ASPECT, place).visible) return false;
    if (!pane) return true;
    const { x, y, z } = axis.set(...place).applyMatrix4(this.cameras.at(name, ASPECT).matrixWorldInverse);
    const wide = -z / pane.distance / 2;
    return Math.abs(x) <= wide * pane.width && Math.abs(y) <= wide * pane.height;
  }

  /** Returns whether no body except `own` is between the lens and a point. */
  private clear(camera: Camera, place: Vec3, own: Body | null): boolean {
    const seen = this.cameras.at(camera.name, ASPECT);
    lens.setFromMatrixPosition(seen.matrixWorld);
    way.set(...place).sub(lens);
    const distance = way.length();
    way.divideScalar(distance);
    const [first] = this.cast(seen, distance - OWN);
    return !first || first.object.parent === own?.group;
  }

  /** Returns the obstacles along a ray from the lens, beyond the near plane and up to a distance [m]. */
  private cast(seen: PerspectiveCamera, distance: number): Intersection[] {
    axis.set(0, 0, -1).transformDirection(seen.matrixWorld);
    ray.set(lens, way);
    ray.near = seen.near / Math.max(way.dot(axis), 1e-3);
    ray.far = distance;
    return ray.intersectObjects(this.meshes, false);
  }

  private samplesOf(body: Body): readonly Vector3[] {
    const known = this.samples.get(body.group.name);
    if (known) return known;
    const box = body.box();
    const [middle, half] = [box.getCenter(new Vector3()), box.getSize(new Vector3()).multiplyScalar(0.5)];
    const faces = [0, 1, 2].flatMap((k) =>
      [1, -1].map((sign) =>
        middle.clone().setComponent(k, middle.getComponent(k) + sign * half.getComponent(k)),
      ),
    );
    const samples = box.isEmpty() ? [] : [middle, ...faces];
    this.samples.set(body.group.name, samples);
    return samples;
  }
}

function round(value: number): number {
  return Math.round(value * STEPS) / STEPS;
}

/** A point on a line, from one end (0) to the other (1). */
function between(a: Vec3, b: Vec3, part: number): Vec3 {
  const [x = 0, y = 0, z = 0] = a.map((value, i) => value + part * ((b[i] ?? 0) - value));
  return [x, y, z];
}

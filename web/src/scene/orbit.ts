/** The engineering view: a camera that mouse and keys rotate around a centre. */

import { type Matrix4, Vector3 } from 'three';
import { clamp } from '../basics/clamp';
import type { Camera, Vec3 } from '../link/protocol';
import type { View } from './view';

/** Greatest elevation [rad]. At 90°, the directions left and right would be undefined. */
const STEEPEST = 1.45;
const UP = new Vector3(0, 0, 1);
const [NEAREST, FARTHEST] = [1.5, 120];
const [way, across] = [new Vector3(), new Vector3()];

/** A view of a place of the scene. */
export interface Placed {
  readonly centre: Vec3;
  /** Distance of the lens from the centre [m]. */
  readonly distance: number;
  /** Azimuth and elevation of the lens, seen from the centre, in the frame of the camera's body [rad]. */
  readonly heading: number;
  readonly rise: number;
}

export class Orbit {
  /** Initial centre, present centre, and shift of the view, in the frame of the camera's body [m]. */
  private readonly place: Vector3;
  private readonly middle: Vector3;
  private readonly shifted = new Vector3();
  private distance: number;
  private heading: number;
  private rise: number;

  /** Starts at the camera's pose. The initial centre is on the camera's axis, near the origin of its body. */
  constructor(private readonly camera: Camera) {
    const eye = new Vector3(...camera.position);
    const look = way.set(...camera.boresight).normalize();
    this.distance = clamp(-eye.dot(look), NEAREST, FARTHEST);
    this.place = eye.clone().addScaledVector(look, this.distance);
    this.middle = this.place.clone();
    this.heading = Math.atan2(-look.y, -look.x);
    this.rise = Math.asin(-look.z);
  }

  /** Rotates the camera around the centre, to the right and upwards [rad]. */
  turn(right: number, upwards: number): void {
    this.heading += right;
    this.rise = clamp(this.rise + upwards, -STEEPEST, STEEPEST);
  }

  /** Sets the centre to a position in the scene, and puts it into the middle of the picture; null: initial centre. */
  turnTo(at: Vec3 | null, toBody: Matrix4): void {
    this.shifted.set(0, 0, 0);
    this.middle.copy(this.place);
    if (at) this.follow(at, toBody);
  }

  /** Looks at a place of the scene from a direction. */
  lookAt({ centre, distance, heading, rise }: Placed, toBody: Matrix4): void {
    this.turnTo(centre, toBody);
    this.heading = heading;
    this.rise = clamp(rise, -STEEPEST, STEEPEST);
    this.distance = clamp(distance, NEAREST, FARTHEST);
  }

  /** Moves the centre to a position in the scene. */
  follow([x, y, z]: Vec3, toBody: Matrix4): void {
    this.middle.set(x, y, z).applyMatrix4(toBody);
  }

  /**
   * Shifts the view to the right and upwards, so that the centre follows the pointer. `right` and `upwards` are
   * angles, as in `turn` [rad]: π shifts the view by the width of the picture.
   */
  shift(right: number, upwards: number): void {
    const [x, y, z] = this.view.boresight;
    const wide = (2 * this.distance * Math.tan(this.camera.field_of_view / 2)) / Math.PI;
    way.set(x, y, z);
    across.crossVectors(way, UP).normalize();
    this.shifted.addScaledVector(across, right * wide);
    this.shifted.addScaledVector(across.cross(way), upwards * wide);
  }

  /** Brings the camera nearer by a factor: 2 halves the distance. */
  approach(factor: number): void {
    this.distance = clamp(this.distance / factor, NEAREST, FARTHEST);
  }

  get view(): View {
    const { heading, rise, distance, middle, shifted } = this;
    const level = Math.cos(rise);
    const out: Vec3 = [level * Math.cos(heading), level * Math.sin(heading), Math.sin(rise)];
    const [x, y, z] = out;
    way.set(x, y, z).multiplyScalar(distance).add(middle).add(shifted);
    return {
      position: [way.x, way.y, way.z],
      boresight: [-x, -y, -z],
      up: [0, 0, 1],
      angle: this.camera.field_of_view,
    };
  }
}

/** The engineering view: an eye that goes round a point, moved freely by mouse and keys. */

import { Vector3 } from 'three';
import { clamp } from '../clamp';
import type { Camera, Vec3 } from '../protocol';
import type { View } from './view';

/** It does not look straight down or up, where left and right would change sides [rad]. */
const STEEPEST = 1.45;
const [NEAREST, FARTHEST] = [1.5, 120];
const way = new Vector3();

export class Orbit {
  /** What it goes round, in its body's frame [m]. */
  private readonly middle: Vector3;
  private distance: number;
  private heading: number;
  private rise: number;

  /** Begins as the camera stands, which looks at a point over the origin of its body. */
  constructor(private readonly camera: Camera) {
    const eye = new Vector3(...camera.position);
    const look = way.set(...camera.boresight).normalize();
    this.distance = clamp(-eye.dot(look), NEAREST, FARTHEST);
    this.middle = eye.clone().addScaledVector(look, this.distance);
    this.heading = Math.atan2(-look.y, -look.x);
    this.rise = Math.asin(-look.z);
  }

  /** Goes round, to the right and upwards [rad]. */
  turn(right: number, upwards: number): void {
    this.heading += right;
    this.rise = clamp(this.rise + upwards, -STEEPEST, STEEPEST);
  }

  /** Comes nearer by a factor: 2 halves the distance. */
  approach(factor: number): void {
    this.distance = clamp(this.distance / factor, NEAREST, FARTHEST);
  }

  get view(): View {
    const { heading, rise, distance, middle } = this;
    const level = Math.cos(rise);
    const out: Vec3 = [level * Math.cos(heading), level * Math.sin(heading), Math.sin(rise)];
    const [x, y, z] = out;
    way.set(x, y, z).multiplyScalar(distance).add(middle);
    return {
      position: [way.x, way.y, way.z],
      boresight: [-x, -y, -z],
      up: [0, 0, 1],
      angle: this.camera.field_of_view,
    };
  }
}

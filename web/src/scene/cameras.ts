import { MathUtils, Matrix4, PerspectiveCamera, Quaternion, Vector3 } from 'three';
import { present } from '../assert';
import type { Camera, Quat, Vec3 } from '../protocol';
import type { Body } from './bodies';

const NEAR = 0.08;
const FAR = 400;
const ORIGIN = new Vector3();
const point = new Vector3();
const [start, end] = [new Vector3(), new Vector3()];
const turn = new Quaternion();
const AXES = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)] as const;

/** A place in a picture: 0 to 1 from its left and from its top. */
export interface Place {
  readonly x: number;
  readonly y: number;
}

/** A point in a picture; `visible` where it lies in it. */
export interface Projected extends Place {
  readonly visible: boolean;
}

/** A television camera on its body. */
class Mounted {
  private readonly picture = new PerspectiveCamera(40, 1, NEAR, FAR);
  private readonly inBody: Matrix4;
  private aspect = 0;

  constructor(
    private readonly camera: Camera,
    private readonly body: Body,
  ) {
    this.picture.matrixAutoUpdate = this.picture.matrixWorldAutoUpdate = false;
    const boresight = new Vector3(...camera.boresight);
    this.inBody = new Matrix4().lookAt(ORIGIN, boresight, new Vector3(...camera.up));
    this.inBody.setPosition(...camera.position);
  }

  /** The camera where its body is now; its stated field of view is the horizontal one at every aspect. */
  at(aspect: number): PerspectiveCamera {
    const { picture } = this;
    if (this.aspect !== aspect) {
      const half = Math.atan(Math.tan(this.camera.field_of_view / 2) / aspect);
      picture.fov = MathUtils.radToDeg(2 * half);
      this.aspect = picture.aspect = aspect;
      picture.updateProjectionMatrix();
    }
    picture.matrixWorld.multiplyMatrices(this.body.group.matrixWorld, this.inBody);
    picture.matrixWorldInverse.copy(picture.matrixWorld).invert();
    return picture;
  }
}

/** All cameras of a scene by their short names. */
export class Cameras {
  private readonly mounted = new Map<string, Mounted>();

  constructor(cameras: readonly Camera[], bodies: readonly Body[]) {
    for (const camera of cameras) {
      const body = bodies.find(({ group }) => group.name === camera.body);
      this.mounted.set(camera.name, new Mounted(camera, present(body, `body ${camera.body}`)));
    }
  }

  /** The camera as it stands now, for a picture of this width over height. */
  at(name: string, aspect: number): PerspectiveCamera {
    return present(this.mounted.get(name), `camera ${name}`).at(aspect);
  }

  /** Where a point of the scene lies in a camera's picture. */
  project(name: string, aspect: number, position: Vec3): Projected {
    const camera = this.at(name, aspect);
    point.set(...position).applyMatrix4(camera.matrixWorldInverse);
    const ahead = point.z < -NEAR;
    point.applyMatrix4(camera.projectionMatrix);
    const [x, y] = [(1 + point.x) / 2, (1 - point.y) / 2];
    return { x, y, visible: ahead && x >= 0 && x <= 1 && y >= 0 && y <= 1 };
  }

  /**
   * Where a straight line of the scene lies in a camera's picture, as far as it is before the camera: its ends,
   * 0 to 1 from the left and from the top, not cut off at the picture's edges; null: it is all behind it.
   */
  segment(name: string, aspect: number, a: Vec3, b: Vec3): readonly [Place, Place] | null {
    const camera = this.at(name, aspect);
    start.set(...a).applyMatrix4(camera.matrixWorldInverse);
    end.set(...b).applyMatrix4(camera.matrixWorldInverse);
    if (start.z > -NEAR && end.z > -NEAR) return null;
    if (start.z > -NEAR) start.lerp(end, (start.z + NEAR) / (start.z - end.z));
    else if (end.z > -NEAR) end.lerp(start, (end.z + NEAR) / (end.z - start.z));
    const seen = (place: Vector3): Place => {
      place.applyMatrix4(camera.projectionMatrix);
      return { x: (1 + place.x) / 2, y: (1 - place.y) / 2 };
    };
    return [seen(start), seen(end)];
  }

  /** A frame's three axes as a camera sees them: x right, y up, z towards the viewer. */
  directions(name: string, [w, x, y, z]: Quat): [Vec3, Vec3, Vec3] {
    const camera = this.at(name, 1);
    turn.set(x, y, z, w);
    const seen = (axis: Vector3): Vec3 => {
      point.copy(axis).applyQuaternion(turn).transformDirection(camera.matrixWorldInverse);
      return [point.x, point.y, point.z];
    };
    return [seen(AXES[0]), seen(AXES[1]), seen(AXES[2])];
  }
}

import { Matrix4, type PerspectiveCamera, Quaternion, Vector3 } from 'three';
import { present } from '../basics/assert';
import type { Camera, Quat, Vec3 } from '../link/protocol';
import type { Body } from './bodies';
import type { Part } from './drawn';
import { WHOLE } from './free-part';
import { Lens } from './lens';
import { Orbit, type Placed } from './orbit';
import { settingOf, type View, viewOf } from './view';

/** Near plane [m]. For a camera behind a window, the near plane is beyond the window's pane. */
const NEAR = 0.01;
const FAR = 400;
const ORIGIN = new Vector3();
const point = new Vector3();
const [start, end] = [new Vector3(), new Vector3()];
const turn = new Quaternion();
const inverse = new Matrix4();
const AXES = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)] as const;

/** A position in a picture: 0 to 1 from its left and from its top. */
export interface Place {
  readonly x: number;
  readonly y: number;
}

/** A point in a picture; `visible` if it is inside the picture. */
export interface Projected extends Place {
  readonly visible: boolean;
}

/** A television camera on its body. */
class Mounted {
  private readonly picture: Lens;
  private readonly inBody = new Matrix4();
  /** Present pan, tilt and horizontal field of view [rad]. */
  setting: Vec3;

  constructor(
    readonly camera: Camera,
    private readonly body: Body,
  ) {
    const near = camera.pane?.distance ?? NEAR;
    this.picture = new Lens(near, FAR);
    this.picture.matrixAutoUpdate = this.picture.matrixWorldAutoUpdate = false;
    this.setting = settingOf(camera);
    this.look(viewOf(camera, this.setting));
  }

  /** Sets the drives: pan, tilt, horizontal field of view [rad]. */
  put(setting: Vec3): void {
    if (setting.every((angle, i) => angle === this.setting[i])) return;
    this.setting = setting;
    this.look(viewOf(this.camera, setting));
  }

  /** Takes the camera's fields, which may have changed. */
  renew(): void {
    if (this.camera.drive === null) this.setting = settingOf(this.camera);
    if (this.camera.kind !== 'engineering') this.look(viewOf(this.camera, this.setting));
  }

  /** Transform from the scene frame to the frame of the camera's body. */
  get toBody(): Matrix4 {
    return inverse.copy(this.body.group.matrixWorld).invert();
  }

  look({ position, boresight, up, angle }: View): void {
    this.inBody.lookAt(ORIGIN, start.set(...boresight), end.set(...up));
    this.inBody.setPosition(...position);
    this.picture.angle = angle;
  }

  /** Returns the camera at its body's present pose. */
  at(aspect: number, free: Part): PerspectiveCamera {
    const { picture } = this;
    picture.fit(aspect, free);
    picture.matrixWorld.multiplyMatrices(this.body.group.matrixWorld, this.inBody);
    picture.matrixWorldInverse.copy(picture.matrixWorld).invert();
    return picture;
  }
}

/** All cameras of a scene by their short names. */
export class Cameras {
  private readonly mounted = new Map<string, Mounted>();
  private readonly driven: readonly Mounted[];
  private readonly orbits = new Map<string, Orbit>();

  constructor(cameras: readonly Camera[], bodies: readonly Body[]) {
    for (const camera of cameras) {
      const body = bodies.find(({ group }) => group.name === camera.body);
      this.mounted.set(camera.name, new Mounted(camera, present(body, `body ${camera.body}`)));
      if (camera.kind === 'engineering') this.orbits.set(camera.name, new Orbit(camera));
    }
    this.driven = [...this.mounted.values()].filter(({ camera }) => camera.drive !== null);
  }

  /** Takes over the engineering views of another scene. */
  takeOrbits(other: Cameras): void {
    for (const [name, orbit] of other.orbits) {
      this.orbits.set(name, orbit);
      this.one(name).look(orbit.view);
    }
  }

  /** Sets the drives of each camera that has any, in the cameras' order: pan, tilt, horizontal field of view [rad]. */
  put(views: readonly Vec3[]): void {
    this.driven.forEach((mounted, i) => {
      const view = views[i];
      if (view) mounted.put(view);
    });
  }

  /** Looks anew from the places of the cameras, which changes in flight have changed. */
  renew(): void {
    for (const mounted of this.mounted.values()) mounted.renew();
  }

  /** Returns the present setting of a camera's drives: pan, tilt, horizontal field of view [rad]. */
  setting(name: string): Vec3 {
    return this.one(name).setting;
  }

  /** Sets the centre of the engineering views, and puts it into the middle of the pictures; null: initial centre. */
  turnTo(at: Vec3 | null): void {
    for (const [name, orbit] of this.orbits) {
      const one = this.one(name);
      orbit.turnTo(at, one.toBody);
      one.look(orbit.view);
    }
  }

  /** Moves the centre of the engineering views to a position in the scene. */
  follow(at: Vec3): void {
    for (const [name, orbit] of this.orbits) {
      const one = this.one(name);
      orbit.follow(at, one.toBody);
      one.look(orbit.view);
    }
  }

  /** Rotates an engineering view [rad], or shifts it if `aside`; divides the distance from the centre by `nearer`. */
  orbit(name: string, right: number, upwards: number, nearer: number, aside: boolean): void {
    const orbit = this.orbits.get(name);
    if (!orbit) return;
    if (aside) orbit.shift(right, upwards);
    else orbit.turn(right, upwards);
    orbit.approach(nearer);
    this.one(name).look(orbit.view);
  }

  /** Directs an engineering view at a place of the scene. */
  place(name: string, placed: Placed): void {
    const orbit = this.orbits.get(name);
    const one = this.one(name);
    orbit?.lookAt(placed, one.toBody);
    if (orbit) one.look(orbit.view);
  }

  /**
   * Returns the camera at its present pose and setting.
   *
   * @param aspect the picture's width over its height.
   * @param free the part that no other picture covers.
   */
  at(name: string, aspect: number, free: Part = WHOLE): PerspectiveCamera {
    return this.one(name).at(aspect, free);
  }

  private one(name: string): Mounted {
    return present(this.mounted.get(name), `camera ${name}`);
  }

  /** Position of a point of the scene in a camera's picture. */
  project(name: string, aspect: number, position: Vec3, free: Part = WHOLE): Projected {
    const camera = this.at(name, aspect, free);
    point.set(...position).applyMatrix4(camera.matrixWorldInverse);
    const ahead = point.z < -camera.near;
    point.applyMatrix4(camera.projectionMatrix);
    const [x, y] = [(1 + point.x) / 2, (1 - point.y) / 2];
    return { x, y, visible: ahead && x >= 0 && x <= 1 && y >= 0 && y <= 1 };
  }

  /**
   * Returns the ends of a straight line of the scene in a camera's picture, 0 to 1 from the left and from the top. The
   * part behind the camera is cut off; parts outside the picture are kept. Null if the whole line is behind the camera.
   */
  segment(
    name: string,
    aspect: number,
    a: Vec3,
    b: Vec3,
    free: Part = WHOLE,
  ): readonly [Place, Place] | null {
    const camera = this.at(name, aspect, free);
    start.set(...a).applyMatrix4(camera.matrixWorldInverse);
    end.set(...b).applyMatrix4(camera.matrixWorldInverse);
    const { near } = camera;
    if (start.z > -near && end.z > -near) return null;
    if (start.z > -near) start.lerp(end, (start.z + near) / (start.z - end.z));
    else if (end.z > -near) end.lerp(start, (end.z + near) / (end.z - start.z));
    const seen = (place: Vector3): Place => {
      place.applyMatrix4(camera.projectionMatrix);
      return { x: (1 + place.x) / 2, y: (1 - place.y) / 2 };
    };
    return [seen(start), seen(end)];
  }

  /** Returns the three axes of a coordinate frame as a camera sees them: x right, y up, z towards the viewer. */
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

import { Box3, type BufferGeometry, Euler, Matrix4, Mesh, Object3D, Quaternion, Vector3 } from 'three';
import type { BodyInfo, Light, Shape, Vec3 } from '../link/protocol';
import { Batch } from './batch';
import { type Bend, bendPoints } from './bend';
import type { Quality } from './drawn';
import type { Materials } from './materials';
import { geometriesOf, type Leaf } from './shapes';

const ONE = new Vector3(1, 1, 1);
const MIRROR = new Matrix4().makeScale(1, -1, 1);
const place = new Vector3();
const turn = new Quaternion();

/** Render order before all other meshes: details cover shapes, whose hidden pixels are then not computed. */
const FIRST = -0.5;
/** Render order after all other bodies, but before the sky. */
const LAST = 0.5;

/** A lamp and its pose in its body's frame. */
export interface PlacedLight {
  readonly light: Light;
  readonly place: Matrix4;
}

/** Name, number of triangles and drawn position of a body. */
export interface DrawnBody {
  readonly name: string;
  readonly triangles: number;
  readonly at: Vec3;
}

/** A body: its shapes and details merged into one mesh for each material. It is rigid, or a boom that bends. */
export class Body {
  readonly group = new Object3D();
  readonly lights: PlacedLight[] = [];
  /** The meshes without details, which are not drawn: what hides other bodies, and what a ghost is made of. */
  readonly plain: Mesh[] = [];
  /** Positions of the vertices of each mesh while the body is straight; empty if it is rigid. */
  private readonly straight: Float32Array[] = [];

  /**
   * `end`: end of the boom, if the body bends; null if it is rigid. `shaded`: whether the shadow of the hand falls on it
   * in the low profile.
   */
  constructor(
    info: BodyInfo,
    materials: Materials,
    quality: Quality,
    end: Vec3 | null = null,
    shaded = false,
  ) {
    this.group.name = info.name;
    this.group.matrixAutoUpdate = false;
    const batches = new Map<string, Batch>();
    const batchOf = ({ batch: name }: { batch: string }) => {
      const batch = batches.get(name) ?? new Batch();
      batches.set(name, batch);
      return batch;
    };
    const made = new Map<Leaf, BufferGeometry[]>();
    const geometries = (shape: Leaf) => {
      const found = made.get(shape) ?? geometriesOf(shape, quality); // the copies of a group share them
      made.set(shape, found);
      return found;
    };
    for (const layer of ['shapes', 'details'] as const) {
      for (const [shape, motion] of placed(info[layer], new Matrix4())) {
        if (shape.kind === 'light') this.lights.push({ light: shape, place: motion });
        const look =
          shape.kind === 'light' ? materials.look('glow', shape.switch) : materials.look(shape.material);
        for (const geometry of geometries(shape)) batchOf(look)[layer].add(geometry, motion, look.colour);
      }
    }
    for (const [name, batch] of batches) {
      const { whole, plain } = batch.geometries(end && new Vector3(...end).normalize());
      const mesh = new Mesh(whole, materials.material(name, shaded));
      if (end) {
        this.straight.push(mesh.geometry.getAttribute('position').array.slice() as Float32Array);
        mesh.frustumCulled = false; // its bounds are those of the straight boom
      }
      mesh.name = name;
      mesh.castShadow = mesh.receiveShadow = materials.solid(name);
      mesh.matrixAutoUpdate = false;
      if (2 * (plain.index?.count ?? 0) < (whole.index?.count ?? 0)) mesh.renderOrder = FIRST;
      this.group.add(mesh);
      if (plain.index?.count) this.plain.push(twin(mesh, plain));
    }
  }

  /** Draw this body after all others, so that its hidden pixels are not computed. */
  drawLast(): void {
    for (const mesh of this.group.children) mesh.renderOrder = LAST;
  }

  /** Set the pose in the scene from `poses`: x, y, z and the quaternion w, x, y, z, starting at index `first`. */
  setPose(poses: readonly number[], first: number): void {
    place.fromArray(poses, first);
    turn.set(poses[first + 4] ?? 0, poses[first + 5] ?? 0, poses[first + 6] ?? 0, poses[first + 3] ?? 1);
    this.group.matrix.compose(place, turn, ONE);
    this.group.updateMatrixWorld(true);
  }

  /** Move the body by a motion in the scene. */
  move(motion: Matrix4): void {
    this.group.matrix.premultiply(motion);
    this.group.updateMatrixWorld(true);
  }

  /** Bend the meshes of a boom, which ends at `end` while it is straight [m]. */
  bend(end: Vec3, bend: Bend): void {
    this.group.children.forEach((child, i) => {
      const straight = this.straight[i];
      if (!straight || !(child instanceof Mesh)) return;
      const position = child.geometry.getAttribute('position');
      bendPoints(straight, position.array as Float32Array, end, bend);
      position.needsUpdate = true;
    });
  }

  /** Name, number of triangles, and position of the body in the scene. */
  get drawn(): DrawnBody {
    const triangles = this.group.children.reduce(
      (sum, child) => sum + (child instanceof Mesh ? (child.geometry.index?.count ?? 0) / 3 : 0),
      0,
    );
    const { x, y, z } = place.setFromMatrixPosition(this.group.matrix);
    return { name: this.group.name, triangles, at: [x, y, z] };
  }

  /** Return the mesh of a batch, or undefined if the body has none. */
  mesh(batch: string): Mesh | undefined {
    return this.group.children.find((child): child is Mesh => child instanceof Mesh && child.name === batch);
  }

  /** Return the bounding box of all shapes, without details, in the body's frame. */
  box(): Box3 {
    const box = new Box3();
    for (const { geometry } of this.plain) if (geometry.boundingBox) box.union(geometry.boundingBox);
    return box;
  }

  dispose(): void {
    for (const child of [...this.group.children, ...this.plain])
      if (child instanceof Mesh) child.geometry.dispose();
  }
}

/** Return a mesh with another geometry that moves with `mesh`, but is not drawn. */
function twin(mesh: Mesh, geometry: BufferGeometry): Mesh {
  const made = new Mesh(geometry, mesh.material);
  made.name = mesh.name;
  made.parent = mesh.parent;
  made.matrixWorld = mesh.matrixWorld;
  return made;
}

/** Yield every drawn shape with its pose in the body's frame. A shape in a group is yielded once for each copy. */
function* placed(shapes: readonly Shape[], frame: Matrix4): Generator<readonly [Leaf, Matrix4]> {
  for (const shape of shapes) {
    const motion = motionOf(shape.position, shape.rotation);
    if (shape.kind !== 'group') {
      yield [shape, motion.premultiply(frame)];
      continue;
    }
    const sides = shape.mirror ? [frame, frame.clone().multiply(MIRROR)] : [frame];
    for (const side of sides) {
      for (let i = 0; i < shape.count; i++) {
        const step = motionOf(times(shape.step, i), times(shape.turn, i));
        yield* placed(shape.shapes, step.premultiply(motion).premultiply(side));
      }
    }
  }
}

/** Return the number of lamps of the bodies. */
export function lampCount(bodies: readonly BodyInfo[]): number {
  let count = 0;
  for (const { shapes } of bodies)
    for (const [shape] of placed(shapes, new Matrix4())) if (shape.kind === 'light') count += 1;
  return count;
}

/** Return the transform: roll, pitch, yaw about fixed axes, then the translation. */
function motionOf(position: Vec3, [roll, pitch, yaw]: Vec3): Matrix4 {
  const motion = new Matrix4().makeRotationFromEuler(new Euler(roll, pitch, yaw, 'ZYX'));
  return motion.setPosition(...position);
}

function times([x, y, z]: Vec3, factor: number): Vec3 {
  return [x * factor, y * factor, z * factor];
}

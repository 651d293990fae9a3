import { type BufferGeometry, type Matrix4, Vector3 } from 'three';

type Attribute = ReturnType<BufferGeometry['getAttribute']>;

const [point, facing] = [new Vector3(), new Vector3()];

/** Triangles under construction: positions [m], unit normals, and texture coordinates [m]. */
export class Surface {
  readonly positions: number[] = [];
  readonly normals: number[] = [];
  readonly uvs: number[] = [];
  readonly indices: number[] = [];

  /** Adds a vertex and returns its number. */
  vertex(position: Vector3, normal: Vector3, u: number, v: number): number {
    this.positions.push(position.x, position.y, position.z);
    this.normals.push(normal.x, normal.y, normal.z);
    this.uvs.push(u, v);
    return this.positions.length / 3 - 1;
  }

  /** Adds a triangle with its corners counter-clockwise as seen from outside. */
  triangle(a: number, b: number, c: number): void {
    this.indices.push(a, b, c);
  }

  /** Adds a geometry of three, moved by a rigid motion or a reflection. Triangles with two equal corners are left out. */
  append(geometry: BufferGeometry, motion: Matrix4): void {
    const first = this.positions.length / 3;
    const position = geometry.getAttribute('position');
    const normal = geometry.getAttribute('normal');
    const uv = geometry.getAttribute('uv');
    for (let i = 0; i < position.count; i++) {
      point.fromBufferAttribute(position, i).applyMatrix4(motion);
      facing.fromBufferAttribute(normal, i).transformDirection(motion);
      this.vertex(point, facing, uv.getX(i), uv.getY(i));
    }
    const corners = geometry.index?.array ?? Uint32Array.from({ length: position.count }, (_, i) => i);
    const [second, third] = motion.determinant() < 0 ? [2, 1] : [1, 2];
    for (let i = 0; i < corners.length; i += 3) {
      const [a, b, c] = [corners[i] ?? 0, corners[i + second] ?? 0, corners[i + third] ?? 0];
      if (!same(position, a, b) && !same(position, b, c) && !same(position, c, a))
        this.triangle(first + a, first + b, first + c);
    }
  }
}

function same(position: Attribute, a: number, b: number): boolean {
  return (
    position.getX(a) === position.getX(b) &&
    position.getY(a) === position.getY(b) &&
    position.getZ(a) === position.getZ(b)
  );
}

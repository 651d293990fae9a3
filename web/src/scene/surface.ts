import { type Matrix4, Vector3 } from 'three';

const point = new Vector3();

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

  /** Adds a copy of `other`, moved by a rigid motion or a reflection. */
  append(other: Surface, motion: Matrix4): void {
    const first = this.positions.length / 3;
    for (let i = 0; i < other.positions.length; i += 3) {
      point.fromArray(other.positions, i).applyMatrix4(motion);
      this.positions.push(point.x, point.y, point.z);
      point.fromArray(other.normals, i).transformDirection(motion);
      this.normals.push(point.x, point.y, point.z);
    }
    for (const uv of other.uvs) this.uvs.push(uv);
    const [second, third] = motion.determinant() < 0 ? [2, 1] : [1, 2];
    for (let i = 0; i < other.indices.length; i += 3) {
      for (const corner of [0, second, third]) this.indices.push(first + (other.indices[i + corner] ?? 0));
    }
  }
}

import {
  Box3,
  BufferGeometry,
  type Color,
  Float32BufferAttribute,
  type Matrix4,
  type TypedArray,
  type Vector3,
} from 'three';
import { refine } from './refine';
import { Surface } from './surface';

/** Coloured surface under construction. */
class Layer {
  readonly surface = new Surface();
  readonly colours: number[] = [];

  add(geometry: BufferGeometry, motion: Matrix4, colour: Color): void {
    this.surface.append(geometry, motion);
    for (let i = geometry.getAttribute('position').count; i > 0; i--)
      this.colours.push(colour.r, colour.g, colour.b);
  }

  get count(): number {
    return this.surface.positions.length / 3;
  }
}

/** Shapes of a body that share one material, and details of that material. */
export class Batch {
  readonly shapes = new Layer();
  readonly details = new Layer();

  /**
   * Return two geometries with the same vertices: `whole`, which is drawn, and `plain`, which has no details.
   * `along`: direction in which the surface will bend; null if it is rigid.
   */
  geometries(along: Vector3 | null): { whole: BufferGeometry; plain: BufferGeometry } {
    if (along)
      for (const { surface, colours } of [this.shapes, this.details]) refine(surface, colours, along);
    const [{ surface: shapes }, { surface: details }] = [this.shapes, this.details];
    const whole = new BufferGeometry();
    const attribute = (name: string, size: number, values: (layer: Layer) => readonly number[]) => {
      const all = values(this.shapes).concat(values(this.details));
      whole.setAttribute(name, new Float32BufferAttribute(all, size));
    };
    attribute('position', 3, ({ surface }) => surface.positions);
    attribute('normal', 3, ({ surface }) => surface.normals);
    attribute('uv', 2, ({ surface }) => surface.uvs);
    attribute('color', 3, ({ colours }) => colours);
    const first = this.shapes.count;
    whole.setIndex(shapes.indices.concat(details.indices.map((i) => first + i)));
    if (details.indices.length === 0) {
      whole.computeBoundingBox();
      return { whole, plain: whole };
    }
    const plain = new BufferGeometry();
    for (const [name, values] of Object.entries(whole.attributes)) plain.setAttribute(name, values);
    plain.setIndex(shapes.indices);
    const positions = whole.getAttribute('position').array as TypedArray;
    plain.boundingBox = new Box3().setFromArray(positions.subarray(0, 3 * first));
    return { whole, plain };
  }
}

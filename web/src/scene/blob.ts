import { Mesh, type Scene, ShaderMaterial, Vector2, Vector3 } from 'three';
import type { Body } from './bodies';
import type { Daylight } from './daylight';

/** Length of the shortest body that casts a shadow [m]. */
const SHORTEST = 0.8;
const point = new Vector3();
const ABEAM = new Vector3(0, 1, 0);

const vertexShader = /* glsl */ `
  uniform vec3 across, up;
  varying vec2 place;
  void main() {
    vec4 world = modelMatrix * vec4(position, 1.0);
    place = vec2(dot(world.xyz, across), dot(world.xyz, up));
    gl_Position = projectionMatrix * viewMatrix * world;
  }`;

const fragmentShader = /* glsl */ `
  uniform vec2 ends[2 * COUNT];
  uniform float radii[COUNT];
  varying vec2 place;
  void main() {
    float clear = 1.0;
    for (int i = 0; i < COUNT; i++) {
      vec2 a = ends[2 * i], along = ends[2 * i + 1] - a;
      float t = clamp(dot(place - a, along) / dot(along, along), 0.0, 1.0);
      clear = min(clear, distance(place, a + t * along) / radii[i]);
    }
    gl_FragColor = vec4(0.0, 0.0, 0.02, 0.62 * (1.0 - smoothstep(0.5, 1.0, clear)));
  }`;

/** Simplified moving body that casts the shadow: a rod through the centre of its box. */
interface Rod {
  readonly body: Body;
  readonly from: Vector3;
  readonly to: Vector3;
  readonly radius: number;
}

/** Shadow in the low profile: each moving body casts the soft shadow of a rod, along the sun's rays. */
export class Blob {
  private readonly rods: Rod[];
  private readonly ends: Vector2[];
  private readonly mesh: Mesh;
  private readonly material: ShaderMaterial;
  /** Two directions normal to the sun's rays; shadows are computed in the plane of these directions. */
  private readonly across = new Vector3();
  private readonly up = new Vector3();

  /** Shadows of `casters` on the mesh `ground`. The geometry of `ground` is shared, so `dispose` does not free it. */
  constructor(scene: Scene, ground: Mesh, casters: readonly Body[]) {
    this.rods = casters.flatMap(rodOf);
    this.ends = this.rods.flatMap(() => [new Vector2(), new Vector2()]);
    this.material = new ShaderMaterial({
      defines: { COUNT: this.rods.length },
      uniforms: {
        across: { value: this.across },
        up: { value: this.up },
        ends: { value: this.ends },
        radii: { value: this.rods.map(({ radius }) => radius) },
      },
      vertexShader,
      fragmentShader,
      transparent: true,
      depthWrite: false,
      polygonOffset: true,
      polygonOffsetFactor: -1,
      polygonOffsetUnits: -2,
    });
    this.mesh = new Mesh(ground.geometry, this.material);
    this.mesh.matrixAutoUpdate = false;
    this.mesh.matrixWorld = ground.matrixWorld;
    this.mesh.matrixWorldAutoUpdate = false;
    scene.add(this.mesh);
  }

  /** Set the sun. Without sunlight there is no shadow. */
  set({ toSun, sun }: Daylight): void {
    this.across.crossVectors(toSun, ABEAM).normalize();
    this.up.crossVectors(this.across, toSun);
    this.mesh.visible = sun.r > 0;
    this.update();
  }

  /** Move the shadows with the bodies. */
  update(): void {
    const { across, up } = this;
    this.rods.forEach(({ body, from, to }, i) => {
      const { matrixWorld } = body.group;
      point.copy(from).applyMatrix4(matrixWorld);
      this.ends[2 * i]?.set(point.dot(across), point.dot(up));
      point.copy(to).applyMatrix4(matrixWorld);
      this.ends[2 * i + 1]?.set(point.dot(across), point.dot(up));
    });
  }

  dispose(): void {
    this.mesh.removeFromParent();
    this.material.dispose();
  }
}

/** Return the rod in a body's box, or an empty array for a body shorter than `SHORTEST`. */
function rodOf(body: Body): Rod[] {
  const { min, max } = body.box();
  const size = new Vector3().subVectors(max, min);
  const long = [0, 1, 2].reduce((best, axis) => {
    return size.getComponent(axis) > size.getComponent(best) ? axis : best;
  }, 0);
  const radius = Math.min(size.x, size.y, size.z) * 0.6;
  if (size.getComponent(long) < SHORTEST) return [];
  const middle = new Vector3().addVectors(min, max).multiplyScalar(0.5);
  const [from, to] = [middle.clone(), middle.clone()];
  from.setComponent(long, min.getComponent(long) + radius / 2);
  to.setComponent(long, max.getComponent(long) - radius / 2);
  return [{ body, from, to, radius }];
}

import { Mesh, type Scene, ShaderMaterial, Vector2, Vector3 } from 'three';
import type { Body } from './bodies';
import type { Daylight } from './daylight';
import { acrossRays, type Rod, rodOf } from './rod';

const point = new Vector3();

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
    acrossRays(toSun, this.across, this.up);
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

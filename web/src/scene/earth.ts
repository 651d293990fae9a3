import {
  BackSide,
  BufferGeometry,
  Color,
  DoubleSide,
  Float32BufferAttribute,
  type IUniform,
  Matrix3,
  Matrix4,
  Mesh,
  Quaternion,
  type Scene,
  ShaderMaterial,
  SphereGeometry,
  Vector3,
  type WebGLRenderer,
} from 'three';
import { type Daylight, FULL_SUN } from './daylight';
import type { Quality } from './drawn';
import { GROUND, GroundMap } from './ground';

/** Radius of the Earth, and radius of an orbit at 350 km altitude [km]. */
const EARTH = 6371;
const ORBIT = EARTH + 350;
/** Angle from the nadir to the limb: 71.4 deg. */
export const LIMB = Math.asin(EARTH / ORBIT);
const DOWN = new Vector3(0, 0, 1);
/** Angles of the cap's rings from the limb [rad]. Two rings are at the limb: one of the ground, one of the air. */
const RINGS = [
  -LIMB,
  -1,
  -0.75,
  -0.55,
  -0.4,
  -0.28,
  -0.18,
  -0.1,
  -0.05,
  -0.02,
  -1e-6,
  0,
  0.006,
  0.016,
  0.03,
  0.05,
];
/** Number of vertices of a ring. */
const ROUND = 64;

/** Puts the Earth behind all bodies. The direction of each point does not depend on the camera's position. */
const vertexShader = /* glsl */ `
  varying vec3 ray;
  void main() {
    ray = mat3(modelMatrix) * position;
    gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * ray, 1.0);
    gl_Position.z = gl_Position.w * 0.999999;
  }`;

/** Draws the ground where the ray intersects the sphere, haze towards the limb, and a thin blue limb. */
const fragmentShader = /* glsl */ `
  varying vec3 ray;
  uniform vec3 nadir, sun, sunlight;
  uniform mat3 turn;
  uniform float earth, orbit, limb;
  ${GROUND}
  void main() {
    vec3 view = normalize(ray);
    float down = dot(view, nadir);
    float off = acos(clamp(down, -1.0, 1.0)) - limb;
    vec3 colour;
    if (off < 0.0) {
      float along = orbit * down;
      float range = along - sqrt(max(along * along - (orbit * orbit - earth * earth), 0.0));
      vec3 ground = (view * range - nadir * orbit) / earth;
      float height = dot(ground, sun);
      vec4 seen = surface(turn * ground);
      float steepness = -dot(ground, view);
      colour = daylight(height, sunlight) * (clarity(steepness) * seen.rgb + haze(steepness));
      colour += seen.a * clarity(steepness) * cities(height);
    } else {
      vec3 edge = normalize(view - nadir * down) * cos(limb) - nadir * sin(limb);
      colour = rim(off, dot(edge, sun), sunlight);
    }
    gl_FragColor = vec4(colour, 1.0);
    #include <tonemapping_fragment>
    #include <colorspace_fragment>
  }`;

/** Computes at each vertex of the cap what changes slowly: daylight, haze and the light of cities. */
const capVertexShader = /* glsl */ `
  attribute float off;
  varying vec3 day, air, glow;
  varying vec2 place;
  uniform vec3 nadir, sun, sunlight;
  uniform float earth, orbit, limb;
  ${GROUND}
  void main() {
    vec3 view = mat3(modelMatrix) * position;
    if (off < 0.0) {
      float along = orbit * dot(view, nadir);
      vec3 ground = (view * (along - sqrt(max(along * along - orbit * orbit + earth * earth, 0.0))) - nadir * orbit) / earth;
      float height = dot(ground, sun), steepness = -dot(ground, view);
      vec3 light = daylight(height, sunlight);
      day = light * clarity(steepness);
      air = light * haze(steepness);
      glow = clarity(steepness) * cities(height);
    } else {
      vec3 edge = normalize(view - nadir * dot(view, nadir)) * cos(limb) - nadir * sin(limb);
      day = glow = vec3(0.0);
      air = rim(off, dot(edge, sun), sunlight) * smoothstep(0.05, 0.03, off);
    }
    place = uv;
    gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * view, 1.0);
    gl_Position.z = gl_Position.w * 0.999999;
  }`;

const capFragmentShader = /* glsl */ `
  varying vec3 day, air, glow;
  varying vec2 place;
  uniform sampler2D map;
  uniform float exposure;
  void main() {
    vec4 seen = texture2D(map, place);
    gl_FragColor = vec4(sqrt(exposure * (day * seen.rgb * seen.rgb + air + glow * seen.a)), 1.0);
  }`;

/** The Earth. In the full profile a shader computes it; in the low profile it is a cap of the sky with a map. */
export class Earth {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  private readonly map: GroundMap | null;
  private readonly nadir = new Vector3();
  private readonly sun = new Vector3();
  private readonly sunlight = new Color();
  /** Turns the scene's axes to those of the ground, whose z axis is downwards. */
  private readonly turn = new Matrix3();

  /** `exposure`: exposure of the low profile's pictures. */
  constructor(stage: Scene, renderer: WebGLRenderer, quality: Quality, exposure: IUniform<number>) {
    const full = quality === 'full';
    const { nadir, sun, sunlight, turn } = this;
    const sizes = { earth: { value: EARTH }, orbit: { value: ORBIT }, limb: { value: LIMB } };
    this.map = full ? null : new GroundMap(renderer, sizes);
    const light = { nadir: { value: nadir }, sun: { value: sun }, sunlight: { value: sunlight } };
    const material = new ShaderMaterial({
      uniforms: full
        ? { ...sizes, ...light, turn: { value: turn } }
        : { ...sizes, ...light, exposure, map: { value: this.map?.texture } },
      vertexShader: full ? vertexShader : capVertexShader,
      fragmentShader: full ? fragmentShader : capFragmentShader,
      side: full ? BackSide : DoubleSide,
      depthWrite: false,
    });
    this.mesh = new Mesh(full ? new SphereGeometry(100, 48, 32) : cap(), material);
    this.mesh.name = 'earth';
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 1;
    stage.add(this.mesh);
  }

  /** Set the directions of Earth and sun. */
  set(daylight: Daylight): void {
    this.nadir.copy(daylight.nadir);
    this.sun.copy(daylight.toSun);
    this.sunlight.copy(daylight.sun).multiplyScalar(1 / FULL_SUN);
    const facing = new Quaternion().setFromUnitVectors(DOWN, this.nadir);
    this.turn.setFromMatrix4(new Matrix4().makeRotationFromQuaternion(facing)).transpose();
    if (this.map) this.mesh.quaternion.copy(facing);
    this.mesh.updateMatrixWorld();
  }

  dispose(): void {
    this.mesh.removeFromParent();
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.map?.dispose();
  }
}

/** Make the cap of the sky around +z: unit vectors, their angles from the limb [rad], and places on the map. */
function cap(): BufferGeometry {
  const [positions, offs, uvs, indices] = [[], [], [], []] as [number[], number[], number[], number[]];
  RINGS.forEach((off, i) => {
    const angle = LIMB + off;
    for (let k = 0; k <= ROUND; k++) {
      const [c, s] = [Math.cos((2 * Math.PI * k) / ROUND), Math.sin((2 * Math.PI * k) / ROUND)];
      positions.push(c * Math.sin(angle), s * Math.sin(angle), Math.cos(angle));
      offs.push(off);
      const reach = 0.5 * Math.min(1, angle / LIMB);
      uvs.push(0.5 + c * reach, 0.5 + s * reach);
      const b = i * (ROUND + 1) + k;
      const a = b - ROUND - 1;
      if (i > 0 && k < ROUND) indices.push(a, a + 1, b, b, a + 1, b + 1);
    }
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
  geometry.setAttribute('off', new Float32BufferAttribute(offs, 1));
  geometry.setAttribute('uv', new Float32BufferAttribute(uvs, 2));
  geometry.setIndex(indices);
  return geometry;
}

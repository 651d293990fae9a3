import {
  BackSide,
  type BufferGeometry,
  Color,
  DoubleSide,
  type IUniform,
  Mesh,
  type Scene,
  ShaderMaterial,
  SphereGeometry,
  type Texture,
  Vector3,
} from 'three';
import { type Daylight, FULL_SUN } from './daylight';
import type { Quality } from './drawn';
import { paintedCap, paintedClouds } from './painted';

/** Radius of the Earth, and radius of an orbit at 350 km altitude [km]. */
const EARTH = 6371;
const ORBIT = EARTH + 350;
/** Angle from the nadir to the limb: 71.4 deg. */
export const LIMB = Math.asin(EARTH / ORBIT);
/** Brightness of the night side, as a fraction of full daylight: much more than in moonlight, to show the limb. */
const NIGHT = '0.004';
const UP = new Vector3(0, 0, 1);

/** Puts the Earth behind all bodies. The direction of each point does not depend on the camera's position. */
const vertexShader = /* glsl */ `
  varying vec3 ray;
  #ifdef PAINTED
    uniform vec3 nadir, sun, sunlight;
    uniform float earth, orbit, exposure;
    attribute vec3 color;
    varying vec3 tint;
    varying vec2 place;
  #endif
  void main() {
    ray = mat3(modelMatrix) * position;
    #ifdef PAINTED
      vec3 view = normalize(ray);
      float along = orbit * dot(view, nadir);
      vec3 ground = (view * (along - sqrt(max(along * along - orbit * orbit + earth * earth, 0.0))) - nadir * orbit) / earth;
      float day = max(1.25 * dot(ground, sun), 0.0);
      tint = color * sqrt(exposure * (day * sunlight + NIGHT));
      place = uv;
    #endif
    gl_Position = projectionMatrix * vec4(mat3(viewMatrix) * ray, 1.0);
    gl_Position.z = gl_Position.w * 0.999999;
  }`;

/** Draws sea, land and clouds where the ray intersects the sphere, haze towards the limb, and a thin blue limb. */
const fragmentShader = /* glsl */ `
  varying vec3 ray;
  uniform vec3 nadir, sun, sunlight;
  uniform float earth, orbit, limb;

  float hash(vec3 cell) {
    cell = fract(cell * vec3(0.1031, 0.1030, 0.0973));
    cell += dot(cell, cell.yxz + 33.33);
    return fract((cell.x + cell.y) * cell.z);
  }
  float noise(vec3 p) {
    vec3 c = floor(p), f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    vec2 k = vec2(0.0, 1.0);
    vec4 low = vec4(hash(c), hash(c + k.yxx), hash(c + k.xyx), hash(c + k.yyx));
    vec4 high = vec4(hash(c + k.xxy), hash(c + k.yxy), hash(c + k.xyy), hash(c + k.yyy));
    vec4 z = mix(low, high, f.z);
    return mix(mix(z.x, z.y, f.x), mix(z.z, z.w, f.x), f.y);
  }
  float cloudy(vec3 p) {
    float sum = 0.0, weight = 0.5;
    for (int i = 0; i < 6; i++) {
      sum += weight * noise(p);
      p = p * 2.07 + 11.0;
      weight *= 0.5;
    }
    return sum;
  }
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
      vec3 day = max(height, 0.0) * sunlight * mix(vec3(1.0, 0.55, 0.3), vec3(1.0), smoothstep(0.0, 0.25, height)) + NIGHT;
      float weather = cloudy(ground * 9.0 + 3.0);
      vec3 drift = vec3(cloudy(ground * 30.0), cloudy(ground * 30.0 + 40.0), weather);
      float cloud = smoothstep(0.5, 0.66, 0.5 * weather + 0.5 * cloudy(ground * 70.0 + 2.4 * drift));
      float dry = smoothstep(0.58, 0.64, cloudy(ground * 6.0 + 5.0));
      vec3 surface = mix(vec3(0.012, 0.055, 0.16), vec3(0.13, 0.1, 0.05), 0.7 * dry);
      surface = mix(surface, vec3(0.62, 0.66, 0.70), 0.8 * cloud);
      float grazing = 1.0 - clamp(-dot(ground, view), 0.0, 1.0);
      vec3 air = vec3(0.14, 0.32, 0.62) * pow(grazing, 2.5);
      colour = day * (surface * 1.1 + air * 0.8);
    } else {
      vec3 rim = normalize(view - nadir * dot(view, nadir));
      float height = dot(rim * cos(limb) - nadir * sin(limb), sun);
      vec3 day = smoothstep(-0.12, 0.4, height) * sunlight + NIGHT;
      colour = day * (vec3(0.20, 0.40, 0.78) * exp(-off * 60.0) + vec3(0.32, 0.40, 0.48) * exp(-off * 260.0));
    }
    gl_FragColor = vec4(colour, 1.0);
    #include <tonemapping_fragment>
    #include <colorspace_fragment>
  }`;

const paintedShader = /* glsl */ `
  varying vec3 tint;
  varying vec2 place;
  uniform sampler2D clouds;
  void main() {
    gl_FragColor = vec4(tint * texture2D(clouds, place).rgb, 1.0);
  }`;

/** The Earth. In the full profile a shader computes it; in the low profile it is a painted cap of the sky. */
export class Earth {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  private readonly texture: Texture | null;
  private readonly nadir = new Vector3();
  private readonly sun = new Vector3();
  private readonly sunlight = new Color();

  /** `exposure`: exposure of the low profile's pictures. */
  constructor(
    stage: Scene,
    private readonly quality: Quality,
    exposure: IUniform<number>,
  ) {
    const full = quality === 'full';
    const { nadir, sun, sunlight } = this;
    this.texture = full ? null : paintedClouds();
    const material = new ShaderMaterial({
      defines: { NIGHT, ...(full ? {} : { PAINTED: '' }) },
      uniforms: {
        nadir: { value: nadir },
        sun: { value: sun },
        sunlight: { value: sunlight },
        earth: { value: EARTH },
        orbit: { value: ORBIT },
        limb: { value: LIMB },
        exposure,
        clouds: { value: this.texture },
      },
      vertexShader,
      fragmentShader: full ? fragmentShader : paintedShader,
      side: full ? BackSide : DoubleSide,
      depthWrite: false,
    });
    this.mesh = new Mesh(full ? new SphereGeometry(100, 48, 32) : paintedCap(LIMB), material);
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
    if (this.quality === 'low') this.mesh.quaternion.setFromUnitVectors(UP, this.nadir);
    this.mesh.updateMatrixWorld();
  }

  dispose(): void {
    this.mesh.removeFromParent();
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.texture?.dispose();
  }
}

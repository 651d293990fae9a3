/** The ground below the orbiter and the air over it, as functions of shaders that both drawing profiles share. */

import {
  LinearFilter,
  LinearMipmapNearestFilter,
  Mesh,
  OrthographicCamera,
  PlaneGeometry,
  ShaderMaterial,
  type Texture,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';

/** Brightness of the night side, as a fraction of full daylight: much more than in moonlight, to show the limb. */
const NIGHT = '0.004';
/** Width and height of the map of the ground [px]. */
const SIZE = 640;

/**
 * `surface`: reflectances of sea, land and clouds (rgb), and the light of cities (a, 0 to 1), at a point of the unit
 * sphere whose z axis is below the orbiter. `daylight`: light at a height of the sun [sine]. `haze`: light that the air
 * over the ground scatters, as a fraction of daylight, for a line of sight of this steepness [sine]; `clarity`: part of
 * the ground's light that passes this air. `rim`: light of the air beyond the limb, at an angle from it [rad].
 * `cities`: light of cities at a height of the sun.
 */
export const GROUND = /* glsl */ `
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
  float fractal(vec3 p, int octaves) {
    float sum = 0.0, weight = 0.5;
    for (int i = 0; i < octaves; i++) {
      sum += weight * noise(p);
      p = p * 2.07 + 11.0;
      weight *= 0.5;
    }
    return sum;
  }
  vec4 surface(vec3 ground) {
    float height = fractal(ground * 6.0 + vec3(9.2, 4.1, 7.0), 7);
    float land = smoothstep(0.484, 0.489, height);
    float shelf = smoothstep(0.455, 0.486, height);
    float damp = fractal(ground * 11.0 + 20.0, 4);
    vec3 sea = mix(vec3(0.007, 0.03, 0.095), vec3(0.02, 0.12, 0.17), shelf * shelf);
    vec3 soil = mix(vec3(0.25, 0.18, 0.1), vec3(0.05, 0.08, 0.035), smoothstep(0.4, 0.52, damp));
    soil = mix(soil, vec3(0.13, 0.1, 0.075), smoothstep(0.55, 0.66, height)) * (0.7 + 0.6 * fractal(ground * 120.0, 3));
    float weather = fractal(ground * 7.0 + 3.0, 4);
    vec3 drift = vec3(noise(ground * 24.0), noise(ground * 24.0 + 40.0), weather);
    float wisps = fractal(ground * 44.0 + 3.0 * drift, 5);
    float puffs = fractal(ground * 340.0, 3);
    float cloud = smoothstep(0.5, 0.72, 0.56 * weather + 0.44 * wisps + 0.02);
    cloud = max(cloud, 0.6 * smoothstep(0.47, 0.7, puffs) * smoothstep(0.42, 0.55, weather + 0.2 * (wisps - 0.5)));
    float towns = smoothstep(0.6, 0.9, noise(ground * 60.0)) * (1.0 - smoothstep(0.54, 0.6, height));
    float coast = smoothstep(0.05, 0.0, height - 0.487);
    float lamps = smoothstep(0.5, 0.95, noise(ground * 800.0)) * (0.9 * towns + 0.3 * coast) + 0.35 * pow(towns, 4.0);
    lamps += 0.5 * smoothstep(0.84, 0.96, noise(ground * 400.0));
    vec3 seen = mix(mix(sea, soil, land), vec3(0.66, 0.69, 0.72), 0.92 * cloud);
    return vec4(seen, land * lamps * (1.0 - 0.85 * cloud));
  }
  vec3 daylight(float height, vec3 sunlight) {
    return max(height, 0.0) * sunlight * mix(vec3(1.0, 0.55, 0.3), vec3(1.0), smoothstep(0.0, 0.25, height)) + ${NIGHT};
  }
  vec3 haze(float steepness) {
    return vec3(0.12, 0.27, 0.5) * pow(1.0 - clamp(steepness, 0.0, 1.0), 2.2);
  }
  float clarity(float steepness) {
    return 1.1 * smoothstep(-0.05, 0.35, steepness);
  }
  vec3 rim(float off, float height, vec3 sunlight) {
    vec3 day = smoothstep(-0.12, 0.4, height) * sunlight + ${NIGHT};
    return day * (vec3(0.20, 0.40, 0.78) * exp(-off * 60.0) + vec3(0.32, 0.40, 0.48) * exp(-off * 260.0));
  }
  vec3 cities(float height) {
    return vec3(0.11, 0.07, 0.03) * (1.0 - smoothstep(-0.12, 0.03, height));
  }`;

const vertexShader = /* glsl */ `
  varying vec2 place;
  void main() {
    place = position.xy;
    gl_Position = vec4(position.xy, 0.0, 1.0);
  }`;

/** The map's centre is below the orbiter; the distance from it is the angle of view from there, 1 at the limb. */
const fragmentShader = /* glsl */ `
  varying vec2 place;
  uniform float earth, orbit, limb;
  ${GROUND}
  void main() {
    float off = min(length(place), 1.0) * limb;
    float along = orbit * cos(off);
    float range = along - sqrt(max(along * along - orbit * orbit + earth * earth, 0.0));
    vec3 view = vec3(normalize(place + 1e-6) * sin(off), cos(off));
    vec4 seen = surface((view * range - vec3(0.0, 0.0, orbit)) / earth);
    gl_FragColor = vec4(sqrt(seen.rgb), seen.a);
  }`;

/** Map of the ground, drawn once: square roots of the reflectances, and the light of cities. */
export class GroundMap {
  private readonly target = new WebGLRenderTarget(SIZE, SIZE, {
    depthBuffer: false,
    generateMipmaps: true,
    magFilter: LinearFilter,
    minFilter: LinearMipmapNearestFilter,
  });

  constructor(
    renderer: WebGLRenderer,
    uniforms: Readonly<Record<'earth' | 'orbit' | 'limb', { value: number }>>,
  ) {
    const material = new ShaderMaterial({
      uniforms: { ...uniforms },
      vertexShader,
      fragmentShader,
      depthTest: false,
    });
    const square = new Mesh(new PlaneGeometry(2, 2), material);
    square.frustumCulled = false;
    const before = renderer.getRenderTarget();
    renderer.setRenderTarget(this.target);
    renderer.render(square, new OrthographicCamera());
    renderer.setRenderTarget(before);
    square.geometry.dispose();
    material.dispose();
  }

  get texture(): Texture {
    return this.target.texture;
  }

  dispose(): void {
    this.target.dispose();
  }
}

import { Color, type IUniform, ShaderMaterial, type Texture, Vector2, Vector3, Vector4 } from 'three';
import type { Daylight } from './daylight';
import { isSpot, type Lamp, lampPose, PENUMBRA } from './floodlights';
import { acrossRays, type Rod } from './rod';

/**
 * Least brightness in the hand's shadow, as a fraction of that in sunlight: more than the blankets around it scatter, so
 * that a target in the shadow stays legible.
 */
const SHADE = '0.62';
/**
 * Sums the light of sun, Earth and sky at each vertex. Without lamps it also computes the displayed colour at the
 * vertex, so that a pixel costs only a texture look-up and a product.
 */
const vertexShader = /* glsl */ `
  uniform vec3 toSun, nadir, sun, earthshine, above, below;
  uniform vec2 repeat;
  uniform float exposure;
  varying vec3 lit;
  #ifdef PATTERN
    varying vec2 place;
  #endif
  #ifdef SHADED
    uniform vec3 across, up;
    varying vec3 inRays;
    varying float shade;
  #endif
  #if LAMPS > 0
    varying vec3 tint, at, n;
  #else
    vec3 n;
  #endif
  void main() {
    n = normalize(mat3(modelMatrix) * normal);
    vec3 direct = sun * max(dot(n, toSun), 0.0);
    vec3 light = earthshine * max(dot(n, nadir), 0.0) + mix(below, above, 0.5 + 0.5 * n.z);
    #ifdef PATTERN
      place = uv * repeat;
    #endif
    vec4 world = modelMatrix * vec4(position, 1.0);
    #ifdef SHADED
      inRays = vec3(dot(world.xyz, across), dot(world.xyz, up), dot(world.xyz, toSun));
      shade = max(sqrt(light.g / (light.g + direct.g)), SHADE);
    #endif
    light += direct;
    #if LAMPS > 0
      lit = color * light;
      tint = color;
      at = world.xyz;
    #else
      lit = sqrt(exposure * color * light);
    #endif
    gl_Position = projectionMatrix * viewMatrix * world;
  }`;

/** Sums the light of lamps at each pixel, not at vertices: a near lamp may light only the middle of a large face. */
const fragmentShader = /* glsl */ `
  varying vec3 lit;
  #ifdef PATTERN
    uniform sampler2D pattern;
    varying vec2 place;
  #endif
  #ifdef SHADED
    uniform vec3 rodStart, rodAlong;
    uniform vec2 rodShare;
    uniform float rodRadius;
    varying vec3 inRays;
    varying float shade;
  #endif
  #if LAMPS > 0
    uniform float exposure;
    uniform int lit_lamps;
    uniform vec4 lamps[LAMPS], beams[LAMPS];
    uniform vec3 glows[LAMPS];
    varying vec3 tint, at, n;
  #endif
  void main() {
    vec3 shown = lit;
    #if LAMPS > 0
      vec3 sum = vec3(0.0);
      for (int i = 0; i < LAMPS; i++) {
        if (i >= lit_lamps) break;
        vec3 to = lamps[i].xyz - at;
        float far = dot(to, to), by = inversesqrt(far);
        float reach = max(1.0 - far * lamps[i].w, 0.0);
        float beam = clamp(1.0 + (-dot(to, beams[i].xyz) * by - 1.0) * beams[i].w, 0.0, 1.0);
        sum += glows[i] * (max(dot(to, n), 0.0) * by * by * by * reach * reach * beam);
      }
      shown = sqrt(exposure * (lit + tint * sum));
    #endif
    #ifdef SHADED
      vec3 off = inRays - rodStart;
      off -= clamp(dot(off.xy, rodShare), 0.0, 1.0) * rodAlong;
      shown *= off.z < 0.0 ? mix(shade, 1.0, smoothstep(0.64, 1.0, dot(off.xy, off.xy) * rodRadius)) : 1.0;
    #endif
    #ifdef PATTERN
      shown *= 0.3 + 0.7 * texture2D(pattern, place).rgb;
    #endif
    gl_FragColor = vec4(shown, 1.0);
  }`;

/** Light of the low profile, shared by all its materials. */
export class LambertLight {
  readonly uniforms: Readonly<Record<string, IUniform>>;
  private readonly toSun = new Vector3();
  private readonly nadir = new Vector3();
  private readonly glowing = {
    sun: new Color(),
    earthshine: new Color(),
    above: new Color(),
    below: new Color(),
  };
  /** Exposure of the next pictures, as a factor. */
  readonly exposure = { value: 1 };
  private readonly count = { value: 0 };
  /** Position of each lit lamp, and the reciprocal of its squared reach. */
  private readonly places: readonly Vector4[];
  /** Beam direction of each lit lamp, and slope of its light over the cosine of the angle to the beam; 0: no beam. */
  private readonly beams: readonly Vector4[];
  private readonly glows: readonly Color[];
  private lamps: readonly Lamp[] = [];
  private lit: readonly Lamp[] = [];
  private readonly materials: ShaderMaterial[] = [];
  private shaded = 0;

  /** Two directions normal to the sun's rays. */
  private readonly across = new Vector3();
  private readonly up = new Vector3();
  /** The rod that casts a shadow, from its start: coordinates across the rays (x, y) and towards the sun (z) [m]. */
  private readonly start = new Vector3();
  private readonly along = new Vector3();
  /** Factor of a place across the rays that gives its share of the rod's length [1/m]. */
  private readonly share = new Vector2();
  /** Reciprocal of the rod's squared radius [1/m2]. */
  private readonly radius = { value: 1 };
  private rod: Rod | null = null;

  /** `room`: greatest number of lamps. */
  constructor(readonly room: number) {
    const each = Array.from({ length: room });
    this.places = each.map(() => new Vector4());
    this.beams = each.map(() => new Vector4());
    this.glows = each.map(() => new Color());
    const { toSun, nadir, glowing, exposure, count, places, beams, glows } = this;
    this.uniforms = {
      toSun: { value: toSun },
      nadir: { value: nadir },
      ...Object.fromEntries(Object.entries(glowing).map(([name, value]) => [name, { value }])),
      exposure,
      lit_lamps: count,
      lamps: { value: places },
      beams: { value: beams },
      glows: { value: glows },
      across: { value: this.across },
      up: { value: this.up },
      rodStart: { value: this.start },
      rodAlong: { value: this.along },
      rodShare: { value: this.share },
      rodRadius: this.radius,
    };
  }

  /**
   * Make a material that this light illuminates, with vertex colours that a pattern dims. `shaded`: whether the shadow
   * of the rod falls on it.
   */
  material(pattern: Texture | null, shaded: boolean): ShaderMaterial {
    const made = new ShaderMaterial({
      vertexColors: true,
      defines: {
        LAMPS: this.shaded,
        ...(pattern ? { PATTERN: '' } : {}),
        ...(shaded ? { SHADED: '', SHADE } : {}),
      },
      uniforms: {
        ...this.uniforms,
        pattern: { value: pattern },
        repeat: { value: pattern?.repeat ?? new Vector2(1, 1) },
      },
      vertexShader,
      fragmentShader,
    });
    this.materials.push(made);
    return made;
  }

  /** Set the rod that casts a shadow. */
  cast(rod: Rod | null): void {
    this.rod = rod;
    this.radius.value = rod ? 1 / rod.radius ** 2 : 1;
  }

  /** Set the lamps. */
  take(lamps: readonly Lamp[]): void {
    this.lamps = lamps;
  }

  /**
   * Set the light of sun, Earth and sky, and the switches that are on. Lamps are computed only without sunlight: in
   * sunlight they change little and double the cost of a pixel.
   */
  set(daylight: Daylight, on: ReadonlySet<string>): void {
    const { toSun, nadir, sun, earthshine, above, below } = daylight;
    this.toSun.copy(toSun);
    acrossRays(toSun, this.across, this.up);
    this.nadir.copy(nadir);
    // The radiance of a matt surface is its irradiance divided by pi.
    for (const [name, colour] of Object.entries({ sun, earthshine, above, below }))
      this.glowing[name as keyof typeof this.glowing].copy(colour).multiplyScalar(1 / Math.PI);
    const dark = sun.r + sun.g + sun.b === 0;
    this.lit = dark ? this.lamps.filter(({ light }) => on.has(light.switch)) : [];
    this.count.value = this.lit.length;
    this.shade(this.lit.length > 0 ? this.room : 0);
    this.follow();
  }

  /** Set the number of lamps for which the shaders are compiled. */
  private shade(lamps: number): void {
    if (lamps === this.shaded) return;
    this.shaded = lamps;
    for (const material of this.materials) {
      material.defines = { ...material.defines, LAMPS: lamps };
      material.needsUpdate = true;
    }
  }

  /** Move the lamps and the rod with their bodies. */
  follow(): void {
    const { rod, start, along: length, across, up, toSun } = this;
    if (rod) {
      for (const [place, end] of [[start, rod.from] as const, [length, rod.to] as const]) {
        at.copy(end).applyMatrix4(rod.body.group.matrixWorld);
        place.set(at.dot(across), at.dot(up), at.dot(toSun));
      }
      length.sub(start);
      this.share.set(length.x, length.y).divideScalar(Math.max(length.x ** 2 + length.y ** 2, 1e-9));
    }
    this.lit.forEach((lamp, i) => {
      const [place, beam] = [this.places[i], this.beams[i]];
      if (!place || !beam) return;
      lampPose(lamp, at, along);
      const { cone, reach, intensity } = lamp.light;
      place.set(at.x, at.y, at.z, 1 / reach ** 2);
      beam.set(along.x, along.y, along.z, isSpot(lamp.light) ? steepness(cone) : 0);
      this.glows[i]?.copy(lamp.colour).multiplyScalar(intensity / Math.PI);
    });
  }
}

const [at, along] = [new Vector3(), new Vector3()];

/** Return the slope of the fading, which is linear in the cosine and one half at the middle of the penumbra. */
function steepness(cone: number): number {
  const middle = (Math.cos(cone) + Math.cos(cone * (1 - PENUMBRA))) / 2;
  return 0.5 / (1 - middle);
}

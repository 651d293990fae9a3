import { ShaderMaterial, type Texture, Vector2 } from 'three';
import { EARTHSHINE, NADIR, SKYLIGHT, SUN, TO_SUN } from './lights';

/** Light is summed at the corners, and made a displayable colour there: pixels cost a texture and a product. */
const vertexShader = /* glsl */ `
  uniform vec3 toSun, nadir, sun, earthshine, above, below;
  uniform vec2 repeat;
  varying vec3 lit;
  #ifdef PATTERN
    varying vec2 place;
  #endif
  void main() {
    vec3 n = normalize(mat3(modelMatrix) * normal);
    vec3 light = sun * max(dot(n, toSun), 0.0) + earthshine * max(dot(n, nadir), 0.0);
    light += mix(below, above, 0.5 + 0.5 * n.z);
    lit = pow(color * light, vec3(1.0 / 2.2));
    #ifdef PATTERN
      place = uv * repeat;
    #endif
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

const fragmentShader = /* glsl */ `
  varying vec3 lit;
  #ifdef PATTERN
    uniform sampler2D pattern;
    varying vec2 place;
  #endif
  void main() {
    gl_FragColor = vec4(lit, 1.0);
    #ifdef PATTERN
      gl_FragColor.rgb *= 0.3 + 0.7 * texture2D(pattern, place).rgb;
    #endif
  }`;

/** The low profile's matt material: coloured at the corners, dimmed by a pattern. */
export function lambertMaterial(pattern: Texture | null): ShaderMaterial {
  return new ShaderMaterial({
    vertexColors: true,
    defines: pattern ? { PATTERN: '' } : {},
    uniforms: {
      toSun: { value: TO_SUN },
      nadir: { value: NADIR },
      // A matt surface gives off its irradiance over pi.
      sun: { value: SUN.clone().multiplyScalar(1 / Math.PI) },
      earthshine: { value: EARTHSHINE.clone().multiplyScalar(1 / Math.PI) },
      above: { value: SKYLIGHT.above.clone().multiplyScalar(1 / Math.PI) },
      below: { value: SKYLIGHT.below.clone().multiplyScalar(1 / Math.PI) },
      pattern: { value: pattern },
      repeat: { value: pattern?.repeat ?? new Vector2(1, 1) },
    },
    vertexShader,
    fragmentShader,
  });
}

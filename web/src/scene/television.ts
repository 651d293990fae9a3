/** Television of the early flights: converts a drawn picture to black and white, and adds noise. */

import { Vector2, type WebGLRenderer } from 'three';
import type { Area } from './drawn';
import { PicturePass } from './picture-pass';

/** Luminance by Rec. 601, as in television of that time. The noise depends on the position on the canvas and a seed. */
const fragmentShader = /* glsl */ `
  const float NOISE = 0.07; // amplitude, as a fraction of white
  varying vec2 place;
  uniform sampler2D picture;
  uniform vec2 seed;
  void main() {
    vec3 from = fract((gl_FragCoord.xyx + seed.xyx) * 0.1031);
    from += dot(from, from.yzx + 33.33);
    float noise = NOISE * (2.0 * fract((from.x + from.y) * from.z) - 1.0);
    float light = dot(texture2D(picture, place).rgb, vec3(0.299, 0.587, 0.114));
    gl_FragColor = vec4(vec3(0.03 + 0.94 * light + noise), 1.0);
  }`;

export class Television {
  private readonly seed = { value: new Vector2() };
  private readonly pass: PicturePass;

  constructor(renderer: WebGLRenderer) {
    this.pass = new PicturePass(renderer, fragmentShader, { seed: this.seed });
  }

  /** Converts the picture that was just drawn. */
  show(area: Area): void {
    this.seed.value.set(1000 * Math.random(), 1000 * Math.random());
    this.pass.show(area);
  }

  /** Frees the textures, because the sizes of the pictures have changed. */
  forget(): void {
    this.pass.forget();
  }

  dispose(): void {
    this.pass.dispose();
  }
}

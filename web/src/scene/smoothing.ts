/**
 * Smooths the edges in a drawn picture, as FXAA does (T. Lottes, FXAA white paper, NVIDIA 2009): a pixel with a strong
 * contrast to its neighbours is blended along the edge.
 */

import type { WebGLRenderer } from 'three';
import { PicturePass } from './picture-pass';

/**
 * Green stands for the luminance, and two samples for FXAA's four: this takes half the time if the processor draws. All
 * pixels without an edge keep their value.
 */
const fragmentShader = /* glsl */ `
  const float LEAST = 0.04, SHARE = 0.1; // least contrast of an edge: absolute, and as a share of the brightest pixel
  const float REACH = 8.0; // greatest length of the blending [px]
  varying vec2 place;
  uniform sampler2D picture;
  float at(ivec2 pixel) {
    return texelFetch(picture, pixel, 0).g;
  }
  void main() {
    vec2 size = vec2(textureSize(picture, 0));
    ivec2 pixel = ivec2(place * size);
    float here = at(pixel), a = at(pixel + ivec2(-1, 1)), b = at(pixel + ivec2(1, 1));
    float c = at(pixel + ivec2(-1, -1)), d = at(pixel + ivec2(1, -1));
    float low = min(here, min(min(a, b), min(c, d))), high = max(here, max(max(a, b), max(c, d)));
    if (high - low < max(LEAST, SHARE * high)) discard;
    vec2 along = vec2(c + d - a - b, a + c - b - d);
    along /= min(abs(along.x), abs(along.y)) + max((a + b + c + d) / 32.0, 1.0 / 128.0);
    along = 0.25 * clamp(along, -REACH, REACH) / size;
    gl_FragColor = 0.5 * (texture2D(picture, place + along) + texture2D(picture, place - along));
  }`;

/** Makes the smoothing of a renderer's pictures. */
export function smoothing(renderer: WebGLRenderer): PicturePass {
  return new PicturePass(renderer, fragmentShader);
}

/** Television of the early flights: converts a drawn picture to black and white, and adds noise. */

import {
  BufferGeometry,
  Float32BufferAttribute,
  FramebufferTexture,
  Mesh,
  NoBlending,
  OrthographicCamera,
  RGBFormat,
  ShaderMaterial,
  Scene as Stage,
  Vector2,
  type WebGLRenderer,
} from 'three';
import type { Rect } from './drawn';

/** Amplitude of the noise, as a fraction of white. */
const NOISE = '0.07';

const vertexShader = /* glsl */ `
  varying vec2 place;
  void main() {
    place = 0.5 + 0.5 * position.xy;
    gl_Position = vec4(position.xy, 0.0, 1.0);
  }`;

/** Luminance by Rec. 601, as in television of that time. The noise depends on the position on the canvas and a seed. */
const fragmentShader = /* glsl */ `
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
  private readonly stage = new Stage();
  private readonly camera = new OrthographicCamera();
  private readonly geometry = new BufferGeometry();
  private readonly material = new ShaderMaterial({
    defines: { NOISE },
    uniforms: { picture: { value: null }, seed: { value: new Vector2() } },
    vertexShader,
    fragmentShader,
    depthTest: false,
    depthWrite: false,
    blending: NoBlending,
  });
  /** One texture for each size: pictures of different sizes, such as halves and whole monitors, are drawn in turn. */
  private readonly textures = new Map<string, FramebufferTexture>();
  private readonly corner = new Vector2();

  constructor(private readonly renderer: WebGLRenderer) {
    const corners = [-1, -1, 0, 3, -1, 0, -1, 3, 0]; // one triangle round the whole picture
    this.geometry.setAttribute('position', new Float32BufferAttribute(corners, 3));
    const mesh = new Mesh(this.geometry, this.material);
    mesh.frustumCulled = false;
    this.stage.add(mesh);
  }

  /** Converts the picture that was just drawn in a rectangle of the canvas; `canvas`: the canvas's height [CSS px]. */
  show({ left, top, width, height }: Rect, canvas: number): void {
    const { renderer, corner } = this;
    const { picture, seed } = this.material.uniforms;
    const ratio = renderer.getPixelRatio();
    corner
      .set(left, canvas - top - height)
      .multiplyScalar(ratio)
      .round();
    const texture = this.textureOf(Math.floor(width * ratio), Math.floor(height * ratio));
    renderer.copyFramebufferToTexture(texture, corner);
    if (picture) picture.value = texture;
    seed?.value.set(1000 * Math.random(), 1000 * Math.random());
    renderer.render(this.stage, this.camera);
  }

  /** Frees the textures, because the sizes of the pictures have changed. */
  forget(): void {
    for (const texture of this.textures.values()) texture.dispose();
    this.textures.clear();
  }

  dispose(): void {
    this.forget();
    this.geometry.dispose();
    this.material.dispose();
  }

  private textureOf(width: number, height: number): FramebufferTexture {
    const name = `${width} ${height}`;
    const known = this.textures.get(name);
    if (known) return known;
    const texture = new FramebufferTexture(width, height);
    texture.format = RGBFormat; // the canvas has no alpha either
    texture.internalFormat = 'RGB8';
    this.textures.set(name, texture);
    return texture;
  }
}

/** Computes a drawn picture again from its own pixels, by a fragment shader. */

import {
  BufferGeometry,
  Float32BufferAttribute,
  FramebufferTexture,
  type IUniform,
  LinearFilter,
  Mesh,
  NoBlending,
  OrthographicCamera,
  RGBFormat,
  ShaderMaterial,
  Scene as Stage,
  Vector2,
  type WebGLRenderer,
} from 'three';
import { present } from '../basics/assert';
import type { Area } from './drawn';

/** `place`: position in the picture, 0 to 1 from its bottom left. */
const vertexShader = /* glsl */ `
  varying vec2 place;
  void main() {
    place = 0.5 + 0.5 * position.xy;
    gl_Position = vec4(position.xy, 0.0, 1.0);
  }`;

export class PicturePass {
  readonly uniforms: Record<string, IUniform>;
  private readonly picture: IUniform<FramebufferTexture | null> = { value: null };
  private readonly stage = new Stage();
  private readonly camera = new OrthographicCamera();
  private readonly geometry = new BufferGeometry();
  private readonly material: ShaderMaterial;
  /** One texture for each size: pictures of different sizes, such as halves and whole monitors, are drawn in turn. */
  private readonly textures = new Map<string, FramebufferTexture>();
  private readonly corner = new Vector2();

  /** `fragmentShader` reads the uniform `picture`, and writes the picture's new pixels. */
  constructor(
    private readonly renderer: WebGLRenderer,
    fragmentShader: string,
    uniforms: Record<string, IUniform> = {},
  ) {
    this.uniforms = uniforms;
    this.material = new ShaderMaterial({
      uniforms: { ...uniforms, picture: this.picture },
      vertexShader,
      fragmentShader,
      depthTest: false,
      depthWrite: false,
      blending: NoBlending,
    });
    const corners = [-1, -1, 0, 3, -1, 0, -1, 3, 0]; // one triangle round the whole picture
    this.geometry.setAttribute('position', new Float32BufferAttribute(corners, 3));
    const mesh = new Mesh(this.geometry, this.material);
    mesh.frustumCulled = false;
    this.stage.add(mesh);
  }

  /** Converts the picture that was just drawn; the renderer's viewport is still the picture's area. */
  show({ x, y, width, height }: Area): void {
    const { renderer, corner } = this;
    const texture = this.textureOf(width, height);
    renderer.copyFramebufferToTexture(texture, corner.set(x, y));
    this.picture.value = texture;
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
    if (!this.textures.has(name)) {
      const texture = new FramebufferTexture(width, height);
      texture.format = RGBFormat; // the canvas has no alpha either
      texture.internalFormat = 'RGB8';
      texture.minFilter = texture.magFilter = LinearFilter;
      this.textures.set(name, texture);
    }
    return present(this.textures.get(name), `the texture of ${name} px`);
  }
}

import {
  AgXToneMapping,
  Color,
  Mesh,
  MeshBasicMaterial,
  NoToneMapping,
  PCFShadowMap,
  PMREMGenerator,
  SphereGeometry,
  Scene as Stage,
  type Texture,
  WebGLRenderer,
} from 'three';
import type { Near, Quat, Vec3, Welcome } from '../protocol';
import { Blob } from './blob';
import { Body, type DrawnBody } from './bodies';
import { Cameras, type Place, type Projected } from './cameras';
import { Earth } from './earth';
import { Gap } from './gap';
import { Lights, TO_SUN } from './lights';
import { Materials } from './materials';

/** `full` is for graphics hardware; `low` is quick where the processor draws. */
export type Quality = 'full' | 'low';

/** One picture: a camera by name, and where on the canvas it goes [CSS px from its top left]. */
export interface View {
  readonly camera: string;
  readonly rect: {
    readonly left: number;
    readonly top: number;
    readonly width: number;
    readonly height: number;
  };
}

/** Numbers a body in `Frame.poses`. */
const POSE = 7;
/** The room round the pictures, as the page's own background. */
const ROOM = new Color('#0c0d0e');
const SPACE = new Color('#000000');

/** The orbiter, the arm, the Earth and the light on them, drawn as the cameras see them. */
export class Scene {
  private readonly renderer: WebGLRenderer;
  private readonly stage = new Stage();
  private readonly materials: Materials;
  private readonly bodies: Body[];
  private readonly cameras: Cameras;
  private readonly lights: Lights | null;
  private readonly earth: Earth;
  private readonly blob: Blob | null;
  private readonly gap: Gap;
  private readonly surroundings: Texture | null;
  private width = 0;
  private height = 0;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    welcome: Welcome,
    quality: Quality,
  ) {
    this.renderer = rendererFor(canvas, quality);
    this.materials = new Materials(quality);
    this.bodies = welcome.bodies.map((body) => new Body(body, this.materials, quality));
    for (const { group } of this.bodies) this.stage.add(group);
    this.stage.matrixWorldAutoUpdate = false;
    this.cameras = new Cameras(welcome.cameras, this.bodies);
    this.lights = quality === 'full' ? new Lights(this.stage, this.bodies) : null;
    this.earth = new Earth(this.stage, quality);
    this.surroundings = quality === 'full' ? surroundings(this.renderer, this.earth) : null;
    this.stage.environment = this.surroundings;
    this.stage.environmentIntensity = 0.4;
    const [fixed, ...moving] = this.bodies;
    const ground = quality === 'low' ? fixed?.mesh('liner') : undefined;
    this.blob = ground ? new Blob(this.stage, ground, moving) : null;
    this.gap = new Gap(this.stage, this.bodies);
  }

  get drawn(): readonly DrawnBody[] {
    return this.bodies.map((body) => body.drawn);
  }

  /** Seven numbers a body, in the order of `Welcome.bodies`: x, y, z [m], w, x, y, z in the scene frame. */
  setPoses(poses: readonly number[]): void {
    this.bodies.forEach((body, i) => {
      body.setPose(poses, POSE * i);
    });
    this.blob?.update();
  }

  /** The narrowest gap, drawn as a line in a colour `#rrggbb`, on demand with the plane in it; null: none. */
  setGap(near: Near | null, colour: string, plane: boolean): void {
    this.gap.set(near, colour, plane);
  }

  /** Draws all views anew. */
  draw(views: readonly View[]): void {
    const { renderer } = this;
    this.fit();
    renderer.setScissorTest(false);
    renderer.setClearColor(ROOM);
    renderer.clear();
    renderer.setScissorTest(true);
    renderer.setClearColor(SPACE);
    renderer.shadowMap.needsUpdate = true;
    for (const { camera, rect } of views) {
      const { left, top, width, height } = rect;
      if (width < 1 || height < 1) continue;
      const bottom = this.height - top - height;
      renderer.setViewport(left, bottom, width, height);
      renderer.setScissor(left, bottom, width, height);
      renderer.clear();
      this.gap.fit(width, height);
      renderer.render(this.stage, this.cameras.at(camera, width / height));
    }
  }

  /** Where a point of the scene frame lies in a picture of this width over height. */
  project(camera: string, aspect: number, point: Vec3): Projected {
    return this.cameras.project(camera, aspect, point);
  }

  /** Where a line of the scene lies in a camera's picture; null: behind it. */
  segment(camera: string, aspect: number, a: Vec3, b: Vec3): readonly [Place, Place] | null {
    return this.cameras.segment(camera, aspect, a, b);
  }

  /** A frame's three axes as a camera sees them: x right, y up, z towards the viewer. */
  directions(camera: string, quaternion: Quat): [Vec3, Vec3, Vec3] {
    return this.cameras.directions(camera, quaternion);
  }

  dispose(): void {
    this.blob?.dispose();
    this.gap.dispose();
    this.surroundings?.dispose();
    this.earth.dispose();
    this.lights?.dispose();
    for (const body of this.bodies) body.dispose();
    this.materials.dispose();
    this.renderer.dispose();
  }

  /** Follows the canvas' size on the page. */
  private fit(): void {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === this.width && clientHeight === this.height) return;
    this.width = clientWidth;
    this.height = clientHeight;
    this.renderer.setSize(clientWidth, clientHeight, false);
  }
}

function rendererFor(canvas: HTMLCanvasElement, quality: Quality): WebGLRenderer {
  const full = quality === 'full';
  const renderer = new WebGLRenderer({ canvas, antialias: full, powerPreference: 'high-performance' });
  renderer.setPixelRatio(full ? Math.min(window.devicePixelRatio, 2) : 0.75);
  renderer.autoClear = false;
  renderer.toneMapping = full ? AgXToneMapping : NoToneMapping;
  renderer.toneMappingExposure = 1.1;
  renderer.shadowMap.enabled = full;
  renderer.shadowMap.type = PCFShadowMap;
  renderer.shadowMap.autoUpdate = false;
  return renderer;
}

/** What shiny things reflect: the Earth and the sun. */
function surroundings(renderer: WebGLRenderer, earth: Earth): Texture {
  const stage = new Stage();
  const sphere = new SphereGeometry(3, 16, 12);
  const glare = new MeshBasicMaterial({ color: new Color().setScalar(30) });
  const sun = new Mesh(sphere, glare);
  sun.position.copy(TO_SUN).multiplyScalar(60);
  stage.add(sun, new Mesh(earth.mesh.geometry, earth.mesh.material));
  const generator = new PMREMGenerator(renderer);
  const { texture } = generator.fromScene(stage, 0.02, 0.1, 200);
  generator.dispose();
  sphere.dispose();
  glare.dispose();
  return texture;
}

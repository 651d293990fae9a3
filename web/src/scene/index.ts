import {
  AgXToneMapping,
  Color,
  Mesh,
  MeshBasicMaterial,
  NoToneMapping,
  OrthographicCamera,
  PCFShadowMap,
  PMREMGenerator,
  SphereGeometry,
  Scene as Stage,
  type Texture,
  Vector3,
  WebGLRenderer,
} from 'three';
import { present } from '../basics/assert';
import type { ClosestPoints, LightCondition, Lighting, Quat, Vec3, Welcome } from '../link/protocol';
import type { Drawing } from '../page/quality';
import { LIGHT_OF } from './agx';
import { Blob } from './blob';
import { Body, type DrawnBody, lampCount } from './bodies';
import { Cameras, type Place, type Projected } from './cameras';
import { type Daylight, daylightOf, FULL_SUN } from './daylight';
import type { Quality, Rect, View } from './drawn';
import { Earth } from './earth';
import { Exposure, metered } from './exposure';
import { lampsOf } from './floodlights';
import { Gap } from './gap';
import { Ghost } from './ghost';
import { LambertLight } from './lambert';
import { Lights } from './lights';
import { Materials } from './materials';
import { Meter } from './meter';
import { Relay } from './relay';
import { Sight } from './sight';
import { Sun } from './sun';
import { Television } from './television';

/** Numbers a body in `Frame.poses`. */
const POSE = 7;
/** The room round the pictures, as the page's own background. */
const ROOM = '#0c0d0e';
const ROOM_COLOUR = new Color(ROOM);
const SPACE = new Color('#000000');
/** What the plan lies on, as the page's plate. */
const PLATE = new Color('#161719');
/** From where the plan is seen [m]. */
const HIGH = 150;
/** What light is multiplied by at no stops. */
const EXPOSED = 1.1;
/**
 * Between two meterings of any picture, and twice that between two of one camera's [ms]. To read a picture, the page
 * waits for all that it has asked to be drawn, which takes long where the processor draws.
 */
const METERED_MS = { full: 300, low: 1500 } as const;
/** Invisible change of exposure [stops]. */
const UNSEEN = 50;

/** The orbiter, the arm, the Earth and the light on them, drawn as the cameras see them. */
export class Scene {
  private readonly renderer: WebGLRenderer;
  /** Where the processor draws. */
  private readonly relay: Relay | null;
  private readonly stage = new Stage();
  private readonly materials: Materials;
  private readonly bodies: Body[];
  /** What the cameras see. */
  readonly sight: Sight;
  private readonly cameras: Cameras;
  private readonly lights: Lights | null;
  private readonly earth: Earth;
  private readonly sun: Sun;
  private readonly blob: Blob | null;
  private readonly gap: Gap;
  private readonly ghost: Ghost;
  /** Cameras on the arm: the ghost would fill their pictures. */
  private readonly onArm: ReadonlySet<string>;
  private readonly lambert: LambertLight;
  private readonly conditions: readonly LightCondition[];
  private readonly exposures: ReadonlyMap<string, { readonly exposure: Exposure; at: number }>;
  private readonly meter: Meter;
  private readonly television: Television;
  private meteredAt = 0;
  private surroundings: Texture | null = null;
  private daylight: Daylight | null = null;
  private lit = '';
  private readonly plan = new OrthographicCamera(-1, 1, 1, -1, 1, 2 * HIGH);
  private readonly quality: Quality;
  private width = 0;
  private height = 0;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    welcome: Welcome,
    { quality, software }: Drawing,
  ) {
    this.quality = quality;
    this.renderer = rendererFor(software ? document.createElement('canvas') : canvas, quality);
    this.relay = software ? new Relay(this.renderer, canvas) : null;
    this.lambert = new LambertLight(lampCount(welcome.bodies));
    this.materials = new Materials(quality, this.lambert);
    this.bodies = welcome.bodies.map((body) => new Body(body, this.materials, quality));
    for (const { group } of this.bodies) this.stage.add(group);
    this.stage.matrixWorldAutoUpdate = false;
    this.cameras = new Cameras(welcome.cameras, this.bodies);
    this.sight = new Sight(this.cameras, this.bodies);
    const lamps = lampsOf(this.bodies);
    this.lambert.take(lamps);
    this.lights = quality === 'full' ? new Lights(this.stage, lamps) : null;
    this.earth = new Earth(this.stage, quality, this.lambert.exposure);
    this.sun = new Sun(this.stage);
    this.stage.environmentIntensity = 0.4;
    this.conditions = welcome.conditions;
    this.exposures = new Map(welcome.cameras.map(({ name }) => [name, { exposure: new Exposure(), at: 0 }]));
    this.meter = new Meter(this.renderer, quality === 'full' ? LIGHT_OF : ROOTS);
    this.television = new Television(this.renderer);
    const [fixed, ...moving] = this.bodies; // the place that all others stand in, and they
    fixed?.drawLast();
    const ground = quality === 'low' ? fixed?.mesh('liner') : undefined;
    this.blob = ground ? new Blob(this.stage, ground, moving) : null;
    this.gap = new Gap(this.stage, this.bodies);
    const ghosts = welcome.ghost.flatMap((i) => this.bodies[i] ?? []);
    this.ghost = new Ghost(this.stage, ghosts);
    const carried = new Set(ghosts.map(({ group }) => group.name));
    this.onArm = new Set(welcome.cameras.filter(({ body }) => carried.has(body)).map(({ name }) => name));
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
    this.lambert.follow();
  }

  /** Light, lamps and locked exposures, at a time of the flight [s]. */
  setLighting({ condition, lamps, locked }: Lighting, time: number): void {
    const lit = [condition, ...lamps].join();
    if (lit !== this.lit) this.light(condition, new Set(lamps));
    this.lit = lit;
    const seen = this.meter.collect();
    if (seen) this.exposures.get(seen.camera)?.exposure.meter(metered(seen.lights));
    const base = this.daylight?.exposure ?? 0;
    for (const [name, { exposure }] of this.exposures)
      exposure.follow(time, base, locked.find(({ camera }) => camera === name)?.stops ?? null);
  }

  /** Exposure of a camera's picture relative to full sunlight, to an invisible fraction of a stop. */
  stops(camera: string): number {
    return Math.round((this.exposures.get(camera)?.exposure.stops ?? 0) * UNSEEN) / UNSEEN;
  }

  /** A picture that was drawn is being metered, or has to be. */
  metering(camera: string): boolean {
    return this.exposures.get(camera)?.exposure.settled === false;
  }

  /** Pan, tilt, horizontal field of view [rad] of the cameras that have drives, in order. */
  setViews(views: readonly Vec3[]): void {
    this.cameras.put(views);
  }

  /** Settings of a camera's drives, or those commanded: pan, tilt, horizontal field of view [rad]. */
  setting(camera: string): Vec3 {
    return this.cameras.setting(camera);
  }

  /** Moves an engineering view: round to the right and upwards [rad], or aside, and nearer by a factor. */
  orbit(camera: string, right: number, upwards: number, nearer: number, aside: boolean): void {
    this.cameras.orbit(camera, right, upwards, nearer, aside);
  }

  /** Engineering views go round another thing, at a place of the scene; null: round where they began. */
  turnTo(at: Vec3 | null): void {
    this.cameras.turnTo(at);
  }

  /** What they go round is there now. */
  follow(at: Vec3): void {
    this.cameras.follow(at);
  }

  /** The middle of a body in the scene; null: there is no such body, or nothing of it is drawn. */
  middle(name: string): Vec3 | null {
    const body = this.bodies.find(({ group }) => group.name === name);
    const box = body?.box();
    if (!body || !box || box.isEmpty()) return null;
    const { x, y, z } = box.getCenter(new Vector3()).applyMatrix4(body.group.matrixWorld);
    return [x, y, z];
  }

  /** The narrowest gap, drawn as a line in a colour `#rrggbb`, on demand with the plane in it; null: none. */
  setGap(gap: ClosestPoints | null, colour: string, plane: boolean): void {
    this.gap.set(gap, colour, plane);
  }

  /** Where holding the sticks would take the arm, by the poses of `Welcome.ghost`; null: nothing is shown. */
  setGhost(poses: readonly number[] | null): void {
    this.ghost.set(poses, performance.now());
  }

  /** Clear the canvas; its pictures have new positions from now on. */
  wipe(): void {
    const { renderer } = this;
    this.fit();
    renderer.setScissorTest(false);
    renderer.setClearColor(ROOM_COLOUR);
    renderer.clear();
    this.television.forget();
    this.relay?.wipe(ROOM);
  }

  /** Redraw these views; the others keep their pictures. */
  draw(views: readonly View[]): void {
    const { renderer } = this;
    renderer.setScissorTest(true);
    renderer.setClearColor(SPACE);
    renderer.shadowMap.needsUpdate = true;
    for (const { camera, rect, early } of views) {
      if (!this.aim(rect)) continue;
      this.gap.fit(rect.width, rect.height);
      this.ghost.setVisible(!this.onArm.has(camera));
      const factor = this.expose(this.stops(camera));
      renderer.render(this.stage, this.cameras.at(camera, rect.width / rect.height));
      this.look(camera, rect, factor); // before noise, which is none of the scene's light
      if (early) this.television.show(rect, this.height);
      this.relay?.add(rect, this.height);
    }
  }

  /** All that shall be seen now is drawn: it is on its way to the page. */
  send(): void {
    this.relay?.send();
  }

  /** Whether what was drawn is on the page; where the processor draws, this puts it there once it is done. */
  put(): boolean {
    return this.relay?.put() ?? true;
  }

  /** Meters a picture just drawn, where it is due. */
  private look(camera: string, rect: Rect, factor: number): void {
    const due = this.exposures.get(camera);
    if (!due || !this.meter.free) return;
    const [now, every] = [performance.now(), METERED_MS[this.quality]];
    if (due.exposure.settled && (now - this.meteredAt < every || now - due.at < 2 * every)) return;
    this.meteredAt = due.at = now;
    this.meter.ask(camera, rect, this.height, factor);
  }

  /** Exposes the pictures drawn next so many stops over full sunlight; returns the factor of light. */
  private expose(stops: number): number {
    const factor = EXPOSED * 2 ** stops;
    this.renderer.toneMappingExposure = factor;
    this.lambert.exposure.value = factor;
    return factor;
  }

  private light(condition: string, on: ReadonlySet<string>): void {
    const { daylight: before } = this;
    const daylight = before?.name === condition ? before : daylightOf(this.conditions, condition);
    this.daylight = daylight;
    this.materials.lightUp(on);
    this.lambert.set(daylight, on);
    this.lights?.set(daylight, on);
    if (daylight === before) return;
    this.meter.forget();
    for (const { exposure } of this.exposures.values()) exposure.renew();
    this.earth.set(daylight);
    this.sun.set(daylight);
    this.blob?.set(daylight);
    if (this.quality === 'low') return;
    this.surroundings?.dispose();
    this.surroundings = surroundings(this.renderer, this.earth, daylight);
    this.stage.environment = this.surroundings;
  }

  /** Draws a part of the place as seen from above: x to the right, y upwards from the extent's corner [m]. */
  drawPlan(
    rect: Rect,
    extent: Omit<Rect, 'left' | 'top'> & { readonly x: number; readonly y: number },
  ): void {
    const { renderer, plan } = this;
    const { x, y, width, height } = extent;
    renderer.setScissorTest(true);
    renderer.setClearColor(PLATE);
    if (!this.aim(rect)) return;
    plan.position.set(x + width / 2, y + height / 2, HIGH);
    plan.up.set(0, 1, 0);
    plan.lookAt(plan.position.x, plan.position.y, 0);
    [plan.left, plan.right, plan.top, plan.bottom] = [-width / 2, width / 2, height / 2, -height / 2];
    plan.updateProjectionMatrix();
    plan.updateMatrixWorld();
    this.earth.mesh.visible = false;
    this.ghost.setVisible(false);
    this.expose(this.daylight?.exposure ?? 0);
    renderer.render(this.stage, plan);
    this.relay?.add(rect, this.height);
    this.earth.mesh.visible = true;
  }

  /** Makes a part of the canvas the one that is drawn to, and wipes it; false: it is too small. */
  private aim({ left, top, width, height }: Rect): boolean {
    if (width < 1 || height < 1) return false;
    const bottom = this.height - top - height;
    this.renderer.setViewport(left, bottom, width, height);
    this.renderer.setScissor(left, bottom, width, height);
    this.renderer.clear();
    return true;
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
    this.relay?.dispose();
    this.blob?.dispose();
    this.gap.dispose();
    this.ghost.dispose();
    this.meter.dispose();
    this.television.dispose();
    this.surroundings?.dispose();
    this.earth.dispose();
    this.sun.dispose();
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
  const context = canvas.getContext('webgl2', {
    alpha: false, // nothing behind shows through: the browser need not mix the two
    antialias: full,
    powerPreference: 'high-performance',
    preserveDrawingBuffer: true, // not every picture is drawn every time
  });
  const renderer = new WebGLRenderer({ canvas, context: present(context, 'WebGL 2 for the pictures') });
  renderer.setPixelRatio(full ? Math.min(window.devicePixelRatio, 2) : 0.75);
  renderer.autoClear = false;
  renderer.toneMapping = full ? AgXToneMapping : NoToneMapping;
  renderer.shadowMap.enabled = full;
  renderer.shadowMap.type = PCFShadowMap;
  renderer.shadowMap.autoUpdate = false;
  return renderer;
}

/** Light times exposure, by the byte that the low profile shows it with. */
const ROOTS: readonly number[] = Array.from({ length: 256 }, (_, byte) => (byte / 255) ** 2);

/** What shiny things reflect: the Earth and the sun. */
function surroundings(renderer: WebGLRenderer, earth: Earth, { toSun, sun: light }: Daylight): Texture {
  const stage = new Stage();
  const sphere = new SphereGeometry(3, 16, 12);
  const glare = new MeshBasicMaterial({ color: light.clone().multiplyScalar(30 / FULL_SUN) });
  const sun = new Mesh(sphere, glare);
  sun.position.copy(toSun).multiplyScalar(60);
  stage.add(sun, new Mesh(earth.mesh.geometry, earth.mesh.material));
  const generator = new PMREMGenerator(renderer);
  const { texture } = generator.fromScene(stage, 0.02, 0.1, 200);
  generator.dispose();
  sphere.dispose();
  glare.dispose();
  return texture;
}

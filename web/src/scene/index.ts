import { Color, Scene as Stage, Vector3, type WebGLRenderer } from 'three';
import type { ClosestPoints, Frame, Lighting, Vec3, Welcome } from '../link/protocol';
import type { Drawing } from '../page/quality';
import { Bending, EXAGGERATION } from './bending';
import { Body, type DrawnBody, lampCount } from './bodies';
import { Cameras } from './cameras';
import { type Area, areaOf, type Piece, type Rect, type View } from './drawn';
import { Exposures } from './exposures';
import { Gap } from './gap';
import { Ghost } from './ghost';
import { GoalGhost } from './goal-ghost';
import { Illumination } from './illumination';
import { LambertLight } from './lambert';
import type { Lit } from './lit';
import { Materials } from './materials';
import { type Extent, Overhead } from './overhead';
import type { PicturePass } from './picture-pass';
import { prepare } from './prepare';
import { Relay } from './relay';
import { rendererFor } from './renderer';
import { SAMPLES } from './samples';
import { Sight } from './sight';
import { smoothing } from './smoothing';
import { Television } from './television';

/** Number of values for each body in `Display.poses`. */
const POSE = 7;
/** Name of the body of the scenario's own payload. */
const OWN_PAYLOAD = 'payload';
/** Colour of the look-ahead's ghost, equal to the page's colour of commanded values. */
const COMMANDED = '#78bdf7';
/** Colour between the pictures, equal to the page's background. */
const MARGIN = '#0c0d0e';
const MARGIN_COLOUR = new Color(MARGIN);
const SPACE = new Color('#000000');
/** Background of the plan, equal to the colour of the desk's plate. */
const PLATE = new Color('#161719');
/** Greatest number of pixels of the pictures for each CSS px; a screen with more does not look sharper. */
const FINEST = 2;

/** Whether pictures are on the page, are not complete yet, or are lost because the browser has withdrawn the graphics. */
export type Put = 'drawn' | 'pending' | 'lost';

/** The orbiter, the arm, the Earth and the light on them, drawn as the cameras see them. */
export class Scene {
  readonly cameras: Cameras;
  /** Computes what each camera sees. */
  readonly sight: Sight;
  private readonly renderer: WebGLRenderer;
  /** Transfers the pictures to the page if the processor draws them; null with a graphics card. */
  private readonly relay: Relay | null;
  private readonly stage = new Stage();
  private readonly materials: Materials;
  private readonly bodies: readonly Body[];
  private readonly bending: Bending;
  private readonly illumination: Illumination;
  private readonly exposures: Exposures;
  private readonly gap: Gap;
  private readonly ghost: Ghost;
  private readonly goal: GoalGhost;
  /** Cameras on the arm. Their pictures do not show the ghosts, because these would fill them. */
  private readonly onArm: ReadonlySet<string>;
  private readonly television: Television;
  /** Smooths the edges of moving pictures if the processor draws them; null if edges are smooth when drawn. */
  private readonly smoothing: PicturePass | null;
  private readonly overhead = new Overhead();
  private readonly firstCamera: string;
  private width = 0;
  private height = 0;
  /** Pixels of the screen for each CSS px. */
  private ratio = 1;
  private lost = false;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    welcome: Welcome,
    drawing: Drawing,
  ) {
    const { stage } = this;
    const { quality, software } = drawing;
    this.renderer = rendererFor(software ? document.createElement('canvas') : canvas, drawing);
    this.renderer.domElement.addEventListener('webglcontextlost', () => {
      this.lost = true;
    });
    this.relay = software ? new Relay(this.renderer, canvas) : null;
    const lambert = new LambertLight(lampCount(welcome.bodies));
    const materials = new Materials(quality, lambert);
    const booms = new Map(welcome.flexures.map(({ body, end }) => [body, end]));
    const payloads = new Set(welcome.work.cargo);
    const bodies = welcome.bodies.map(
      (body, i) => new Body(body, materials, quality, booms.get(i), payloads.has(body.name)),
    );
    for (const { group } of bodies) stage.add(group);
    stage.matrixWorldAutoUpdate = false;
    this.materials = materials;
    this.bodies = bodies;
    this.bending = new Bending(welcome, bodies);
    this.cameras = new Cameras(welcome.cameras, bodies);
    this.sight = new Sight(this.cameras, bodies);
    const { conditions } = welcome;
    this.illumination = new Illumination(
      stage,
      this.renderer,
      quality,
      bodies,
      welcome.work.effector[0] ?? '',
      materials,
      lambert,
      conditions,
    );
    const names = welcome.cameras.map(({ name }) => name);
    this.firstCamera = names[0] ?? '';
    this.exposures = new Exposures(names, this.renderer, quality);
    this.television = new Television(this.renderer);
    this.smoothing = software && quality === 'low' ? smoothing(this.renderer) : null;
    this.gap = new Gap(stage, bodies);
    const ghosts = welcome.ghost.flatMap((i) => bodies[i] ?? []);
    this.ghost = new Ghost(stage, ghosts, COMMANDED, { fill: 0.16, rim: 0.9 });
    this.goal = new GoalGhost(stage, bodies, new Set(welcome.work.effector), payloads);
    const carried = new Set(ghosts.map(({ group }) => group.name));
    this.onArm = new Set(welcome.cameras.filter(({ body }) => carried.has(body)).map(({ name }) => name));
  }

  get drawn(): readonly DrawnBody[] {
    return this.bodies.map((body) => body.drawn);
  }

  /**
   * Sets the poses of all bodies to those in a frame's `display.poses`, and bends the booms. A pose is x, y, z [m],
   * w, x, y, z in the scene frame. `now`: the time with which ghosts fade [ms]; null: they do not fade.
   */
  setPoses(frame: Frame, exaggerated: boolean, now: number | null): void {
    const { display, dynamics, work } = frame;
    this.bodies.forEach((body, i) => {
      body.setPose(display.poses, POSE * i);
    });
    const held = [OWN_PAYLOAD, ...work.cargo.flatMap(({ held, name }) => (held ? [name] : []))];
    this.bending.show(dynamics?.bends ?? [], exaggerated ? EXAGGERATION : 1, held);
    this.goal.set(frame, now);
    this.illumination.follow();
    this.renderer.shadowMap.needsUpdate = true;
  }

  /** Sets light, lamps and locked exposures at a time of the run [s]. */
  setLighting({ condition, lamps, locked }: Lighting, time: number): void {
    if (this.illumination.set(condition, lamps)) this.exposures.renew();
    this.exposures.follow(time, this.illumination.stops, locked);
  }

  /** Rounded exposure of a camera's picture [photographic stops above the exposure for full sunlight]. */
  stops(camera: string): number {
    return this.exposures.stops(camera);
  }

  /** Whether a camera's exposure is neither locked nor set from a picture yet. */
  metering(camera: string): boolean {
    return this.exposures.metering(camera);
  }

  /** Computes the light on a point of the scene. */
  get lit(): Lit {
    return this.illumination.lit;
  }

  /** Returns the diameter of a body: the diagonal of its box [m]. */
  diameter(name: string): number {
    const box = this.bodies.find(({ group }) => group.name === name)?.box();
    return box && !box.isEmpty() ? box.getSize(new Vector3()).length() : 0;
  }

  /** Returns the middle of a body in the scene; null if there is no such body, or if it has no drawn shape. */
  middle(name: string): Vec3 | null {
    const body = this.bodies.find(({ group }) => group.name === name);
    const box = body?.box();
    if (!body || !box || box.isEmpty()) return null;
    const { x, y, z } = box.getCenter(new Vector3()).applyMatrix4(body.group.matrixWorld);
    return [x, y, z];
  }

  /** Draws the minimum clearance in a colour `#rrggbb`, and on demand the separating plane; null hides both. */
  setGap(gap: ClosestPoints | null, colour: string, plane: boolean): void {
    this.gap.set(gap, colour, plane);
  }

  /** Shows the bodies of `Welcome.ghost` at the poses of the look-ahead; null hides them. */
  setGhost(poses: readonly number[] | null, now: number | null): void {
    this.ghost.set(poses, now);
  }

  /**
   * Prepares pictures of an area [px]; `progress` receives the fraction that is done. Throws `TooSlow` if they would take
   * too long.
   */
  prepare(area: number, signal: AbortSignal, progress: (done: number) => void): Promise<void> {
    return prepare(this.renderer, this.stage, this.cameras.at(this.firstCamera, 1), area, signal, progress);
  }

  /** Clears the canvas, because its pictures have new positions. */
  wipe(): void {
    const { renderer } = this;
    this.fit();
    renderer.setScissorTest(false);
    renderer.setClearColor(MARGIN_COLOUR);
    renderer.clear();
    this.television.forget();
    this.smoothing?.forget();
    this.relay?.wipe(MARGIN);
  }

  /** Whether `refine` draws still pictures. The full profile, and a graphics card, always draw the best picture. */
  get refines(): boolean {
    return this.smoothing !== null;
  }

  /** Total opacity of the ghosts: it changes while they appear and disappear. */
  get haunting(): number {
    return this.ghost.opacity + this.goal.opacity;
  }

  /** Pixels of the screen for each CSS px. */
  get finest(): number {
    return this.ratio;
  }

  /**
   * Redraws these views; all other views keep their pictures.
   *
   * @param scale their resolution, as a share of the screen's.
   * @param stage called before each view, to set the poses that it shows.
   */
  draw(views: readonly View[], scale: number, stage: (view: View) => void): void {
    const { renderer } = this;
    for (const view of views) {
      const { camera, rect, free, early } = view;
      stage(view);
      const area = this.aim(rect, rect, scale);
      if (!area) continue;
      const factor = this.show(camera, rect);
      renderer.render(this.stage, this.cameras.at(camera, rect.width / rect.height, free));
      this.exposures.measure(camera, area, factor); // before noise is added
      this.smoothing?.show(area);
      if (early) this.television.show(area);
      this.relay?.add(area, this.areaOf(rect));
    }
  }

  /** Draws parts of still pictures in the screen's resolution; `last`: whether these parts complete them. */
  refine(pieces: readonly Piece[], last: boolean): void {
    for (const { view, part, sample } of pieces) {
      const { camera, rect, free } = view;
      const area = this.aim(rect, part, 1);
      if (!area) continue;
      const factor = this.show(camera, rect);
      const lens = this.cameras.at(camera, rect.width / rect.height, free);
      const [x, y] = SAMPLES[sample] ?? [0, 0];
      const whole = this.areaOf(rect);
      lens.setViewOffset(whole.width, whole.height, x, y, whole.width, whole.height);
      this.renderer.render(this.stage, lens);
      lens.clearViewOffset();
      if (sample === SAMPLES.length - 1) this.exposures.measure(camera, whole, factor, last);
      this.relay?.add(area, area, sample);
    }
  }

  /** Draws an extent of the scene from above. */
  drawPlan(rect: Rect, extent: Extent): void {
    const { renderer, illumination } = this;
    const area = this.aim(rect, rect, 1, PLATE);
    if (!area) return;
    illumination.showEarth(false);
    for (const ghost of [this.ghost, this.goal]) ghost.setVisible(false);
    illumination.expose(illumination.stops);
    renderer.render(this.stage, this.overhead.over(extent));
    this.relay?.add(area, area);
    illumination.showEarth(true);
  }

  /** Starts the transfer of the drawn pictures to the page; called after all pictures that are due were drawn. */
  send(): void {
    this.relay?.send();
  }

  /** Whether the browser has withdrawn the graphics, now or earlier. */
  get isLost(): boolean {
    this.lost ||= this.renderer.getContext().isContextLost();
    return this.lost;
  }

  /** Puts the drawn pictures on the page if they are complete. A scene that was lost stays lost. */
  put(): Put {
    if (this.isLost) return 'lost';
    return (this.relay?.transfer() ?? true) ? 'drawn' : 'pending';
  }

  dispose(): void {
    this.relay?.dispose();
    this.gap.dispose();
    this.ghost.dispose();
    this.goal.dispose();
    this.exposures.dispose();
    this.television.dispose();
    this.smoothing?.dispose();
    this.illumination.dispose();
    for (const body of this.bodies) body.dispose();
    this.materials.dispose();
    this.renderer.dispose();
  }

  /** Prepares the stage for a camera's picture; returns the factor by which the picture multiplies light. */
  private show(camera: string, { width, height }: Rect): number {
    this.gap.fit(width, height);
    for (const ghost of [this.ghost, this.goal]) ghost.setVisible(!this.onArm.has(camera));
    return this.illumination.expose(this.stops(camera));
  }

  /**
   * Directs drawing to a picture, and clears a part of it; returns this part, or null if the picture is too small.
   * `scale`: resolution, as a share of the screen's.
   */
  private aim(rect: Rect, part: Rect, scale: number, colour = SPACE): Area | null {
    const { renderer } = this;
    const [whole, area] = [this.areaOf(rect, scale), this.areaOf(part, scale)];
    if (!(area.width >= 1 && area.height >= 1)) return null; // while the page is laid out
    renderer.setViewport(whole.x, whole.y, whole.width, whole.height);
    renderer.setScissor(area.x, area.y, area.width, area.height);
    renderer.setScissorTest(true);
    renderer.setClearColor(colour);
    renderer.clear();
    return area;
  }

  private areaOf(rect: Rect, scale = 1): Area {
    return areaOf(rect, this.height, this.ratio * scale);
  }

  /** Adapts the renderer's size to the size of the canvas on the page. */
  private fit(): void {
    const { clientWidth, clientHeight } = this.canvas;
    const ratio = Math.min(window.devicePixelRatio, FINEST);
    if (clientWidth === this.width && clientHeight === this.height && ratio === this.ratio) return;
    this.width = clientWidth;
    this.height = clientHeight;
    this.ratio = ratio;
    this.renderer.setSize(Math.round(ratio * clientWidth), Math.round(ratio * clientHeight), false);
  }
}

/** The two monitors, all cameras at once, and the one canvas behind them. */

import { present } from '../basics/assert';
import type { Age } from '../link/age';
import { linkOf } from '../link/frames';
import type { PictureFrames } from '../link/picture-frames';
import type { PolygonSource } from '../link/polygon-pictures';
import type { Camera, ClosestPoints, Frame, FreeEye, Welcome } from '../link/protocol';
import { Appearance, type Seventies } from '../page/appearance';
import { keeper } from '../page/local-storage';
import type { Drawing } from '../page/quality';
import { Matrix } from '../panel/monitors/matrix';
import { setClass } from '../panel/parts/dom';
import type { View as DeskView } from '../panel/parts/part';
import type { Scene } from '../scene';
import type { DrawnBody } from '../scene/bodies';
import { ASPECT, type View } from '../scene/drawn';
import { freePart, freeSize, WHOLE } from '../scene/free-part';
import { SLOWEST_MS, TooSlow } from '../scene/trial';
import { type Pictured, PLANES, type Planes } from '../windows/opened';
import { small } from '../words/format';
import { type AgeOf, showAges } from './ages';
import { AllCameras } from './all-cameras';
import type { Sighting, Subject } from './best-pair';
import { Survey } from './coverage';
import { Drawers } from './drawers';
import { Fineness, type Sharpness } from './fineness';
import { type Drawer, firstDrawer, fullDrawer } from './full-profile';
import { Monitors } from './monitors';
import { Offers } from './offers';
import { overlay } from './overlay';
import type { PairOffer } from './pair-offer';
import { ALL, PACES, type Pane, Panes } from './panes';
import { Preparation } from './preparation';
import { Putting } from './putting';
import { drawnGap, isCaution, type Manner, Staging } from './staging';

/** Number of drawings in the low profile before the full profile is prepared: the page then shows its pictures. */
const SHOWN = 3;
/** Centres of the engineering views, besides their initial centre. */
const CENTRES: readonly Subject[] = ['tip', 'payload', 'gap'];
/** Time for which the pictures say that the full profile was given up [ms]. */
const NOTICE_MS = 15_000;
/** A page whose drawers have failed more often than this keeps the low profile. */
const MOST_FAILURES = 1;

export interface PicturesListener {
  /** Opens a secondary window. */
  tearOff?: (what: Pictured | Planes) => void;
  /** Called when the view of all cameras was opened or closed. */
  opened?: (matrix: boolean) => void;
  /** Whether dragging a picture turns its camera. */
  turns?: boolean;
  /** Pictures in the look of 1972; absent if no station computes them. */
  polygons?: PolygonSource;
  /** Called when another pair of cameras is offered, or null when the offer ends. Absent if none are offered. */
  offered?: (offer: PairOffer | null) => void;
  /** Called when a monitor shows another camera, or was split. */
  changed?: () => void;
  /** Called with the reason when the full profile is given up because it is too slow. */
  simplified?: (why: string) => void;
  /** Whether the pictures show a recording, not a live run. */
  recorded?: boolean;
}

/** Pictures that are drawn, but not yet on the page. */
interface Drawn {
  /** Whether all pictures show the frame with a metered exposure. */
  readonly complete: boolean;
  /** Completes the pictures when they are on the page; returns whether they are visible there. */
  show(): boolean;
}

/** Cameras of the monitors, and the survey of all cameras. */
export interface Views {
  readonly monitors: readonly (readonly string[])[];
  readonly cameras: readonly Sighting[];
}

export class Pictures {
  readonly monitors: Monitors;
  readonly matrix: Matrix;
  readonly offers: Offers;
  readonly appearance = new Appearance(keeper, ({ night }) =>
    setClass(document.documentElement, 'night', night),
  );
  private readonly ended = new AbortController();
  private readonly drawers: Drawers;
  private survey: Survey;
  private all: AllCameras;
  private panes: Panes;
  private staging: Staging;
  /** The drawer of the full profile, which replaces the present one when it is ready. */
  private readonly full: Preparation;
  private readonly putting = new Putting(
    () => this.scene.put(),
    (error) => this.fail(error),
    // The low profile is slow only while it compiles its shaders, and a hidden page is not drawn.
    (begun) => {
      const seen = !document.hidden && begun > this.seenAt;
      if (seen && this.drawers.present.quality === 'full') this.simplify(SLOWEST_MS);
    },
  );
  private readonly fineness = new Fineness();
  /** Time at which the page was last hidden or shown again [ms]. */
  private seenAt = 0;
  /** Whether the full profile was too slow. */
  private simple = false;
  private plane = false;
  private exaggerated = false;
  private open = false;
  /** Number of drawings of the page, and with the present drawer. */
  private count = 0;
  private own = 0;
  private orbits = 0;
  /** Centre of the engineering views; null for their initial centre. */
  private round: Subject | null = null;
  /** Frame that was drawn last, and frames whose pictures are on the page. */
  private last: Frame | null = null;
  private onPage: PictureFrames | null = null;

  constructor(
    private readonly welcome: Welcome,
    private readonly profile: Drawing,
    private readonly listener: PicturesListener = {},
  ) {
    const { cameras } = welcome;
    const [first] = cameras;
    if (!first) throw new Error(`The scenario ${welcome.scenario} has no camera.`);
    const { tearOff } = listener;
    this.monitors = new Monitors(cameras, first, {
      changed: () => this.listener.changed?.(),
      chosen: () => this.open && this.showMatrix(false),
      round: () => this.turnRound(),
      orbited: (camera, ...by) => this.orbit(camera, ...by),
      turns: listener.turns ?? false,
      ...(tearOff ? { tearOff } : {}),
      ...(listener.polygons ? { seventies: (index) => this.toggleSeventies(index) } : {}),
      ...(listener.polygons && tearOff && !listener.recorded
        ? { planes: (index) => tearOff(PLANES[index]) }
        : {}),
    });
    this.matrix = new Matrix(cameras, {
      chosen: (camera) => this.monitors.choose(camera),
      ...(tearOff ? { tearOff: () => tearOff('matrix') } : {}),
      ...(listener.polygons ? { seventies: () => this.toggleSeventies(ALL) } : {}),
    });
    const { signal } = this.ended;
    this.appearance.follow(signal);
    const seen = () => {
      this.seenAt = performance.now();
    };
    document.addEventListener('visibilitychange', seen, { signal });
    this.drawers = new Drawers(
      () => firstDrawer(welcome, profile),
      (former) => this.change(former),
    );
    this.full = new Preparation(
      (...given) => fullDrawer(welcome, profile, this.area, ...given),
      (done) => this.setPreparing(done),
    );
    const parts = this.partsOf(this.drawers.present);
    ({ survey: this.survey, all: this.all, panes: this.panes, staging: this.staging } = parts);
    this.offers = new Offers(welcome, this.monitors, (offer) => this.listener.offered?.(offer));
  }

  /** The canvas behind the pictures. */
  get canvas(): HTMLCanvasElement {
    return this.drawers.present.canvas;
  }

  private get scene(): Scene {
    return this.drawers.present.scene;
  }

  /** Area of the canvas in pixels of the screen. */
  private get area(): number {
    const { clientWidth, clientHeight } = this.canvas;
    return clientWidth * clientHeight * this.scene.finest ** 2;
  }

  /** Sharpness of the pictures on the page; null in the full profile and before the first pictures. */
  get sharpness(): Sharpness | null {
    return this.fineness.sharpness;
  }

  /** Makes the parts that depend on the drawer. */
  private partsOf({ scene, canvas, quality }: Drawer) {
    const { welcome, matrix, monitors } = this;
    const survey = new Survey(scene, welcome);
    const all = new AllCameras(matrix, scene, survey, welcome.cameras, PACES[quality].plan);
    const panes = new Panes(canvas, monitors, matrix, quality);
    return { survey, all, panes, staging: new Staging(scene, survey) };
  }

  /** Draws with the drawers' present one from now on. */
  private change(former: Drawer): void {
    const { present } = this.drawers;
    present.scene.cameras.takeOrbits(former.scene.cameras);
    former.canvas.replaceWith(present.canvas);
    this.own = 0;
    this.fineness.forget();
    const parts = this.partsOf(present);
    ({ survey: this.survey, all: this.all, panes: this.panes, staging: this.staging } = parts);
    former.scene.dispose();
    this.setPreparing(null);
  }

  /** Writes the progress of the full profile into the pictures; null when it is not being prepared. */
  private setPreparing(done: number | null): void {
    const text = done === null ? '' : `Preparing the full picture: ${Math.floor(100 * done)} %`;
    for (const picture of this.monitors.both.flatMap(({ halves }) => halves)) picture.setPreparing(text);
  }

  /** Exposure of a camera's picture [photographic stops above the exposure for full sunlight]. */
  stops({ name }: Camera): number {
    return this.scene.stops(name);
  }

  /** Number of times that an engineering view was moved. */
  get moved(): number {
    return this.orbits;
  }

  /** Takes the cameras' places, which changes in flight have changed. */
  renew(): void {
    this.scene.cameras.renew();
  }

  /** Surveys all cameras at the frame drawn last; null before the first frame. */
  views(): Views | null {
    if (!this.last) return null;
    this.survey.lookAll(this.last, drawnGap(this.last));
    const cameras = this.matrix.tiles.flatMap(({ camera }) => this.survey.of(camera) ?? []);
    return { monitors: this.monitors.shown, cameras };
  }

  /** Whether all cameras are shown in place of the monitors. */
  get matrixOpen(): boolean {
    return this.open;
  }

  /** The bodies as they are drawn now. */
  get bodies(): readonly DrawnBody[] {
    return this.scene.drawn;
  }

  /** Whether the separating plane is drawn. */
  get showsPlane(): boolean {
    return this.plane;
  }

  toggleMatrix(): void {
    this.showMatrix(!this.open);
  }

  showMatrix(on: boolean): void {
    this.open = on;
    this.listener.opened?.(on);
  }

  /**
   * Rotates an engineering view [rad]; shifts it instead if `aside` is true or the button *Shift* is on. Divides the
   * distance to the view's centre by `nearer`.
   */
  orbit({ name }: Camera, right: number, upwards: number, nearer: number, aside = false): void {
    this.orbits += 1;
    this.scene.cameras.orbit(name, right, upwards, nearer, aside || this.monitors.slow);
  }

  /** Selects the next centre of the engineering views: initial centre, tip, payload, minimum clearance. */
  private turnRound(): void {
    const all = [null, ...CENTRES];
    this.round = all[(all.indexOf(this.round) + 1) % all.length] ?? null;
    this.orbits += 1;
    this.scene.cameras.turnTo(null);
    for (const monitor of this.monitors.both) monitor.setRound(this.round);
  }

  /** Shows or hides the separating plane; returns whether it is shown now. */
  togglePlane(): boolean {
    this.plane = !this.plane;
    return this.plane;
  }

  /** Whether bending is drawn exaggerated. */
  get exaggerates(): boolean {
    return this.exaggerated;
  }

  /** Draws bending exaggerated, or as it is; returns whether it is exaggerated now. */
  toggleBending(): boolean {
    this.exaggerated = !this.exaggerated;
    return this.exaggerated;
  }

  /** Whether the browser has withdrawn the graphics: the pictures must be drawn again even if nothing has changed. */
  get lost(): boolean {
    return this.scene.isLost;
  }

  /** Whether the pictures drawn last are not on the page yet. Meanwhile no other pictures are drawn. */
  get drawing(): boolean {
    return this.putting.waits;
  }

  /**
   * Draws the pictures that are due; returns whether all pictures show these frames with a metered exposure. Pictures that
   * cannot be drawn are left as they are; their age shows it.
   *
   * @param done called when the pictures are on the page, unless the page's layout has changed since they were drawn.
   */
  draw(frames: PictureFrames, done: () => void): boolean {
    const { drawers, full } = this;
    const next = full.take();
    if (next) drawers.change(next);
    const begun = performance.now();
    if (!drawers.ready(begun)) return false;
    let drawn: Drawn;
    try {
      drawn = this.drawNow(frames, begun);
    } catch (error) {
      this.fail(error);
      return false;
    }
    if (this.wantsFull) void full.start(frames.frame).catch((error: unknown) => this.keepLow(error));
    this.putting.start(begun, drawn.show, done);
    return drawn.complete && !drawers.fault;
  }

  /** Whether the full profile is to be prepared, because the low one has just shown enough pictures. */
  private get wantsFull(): boolean {
    const { profile, drawers } = this;
    const low = profile.quality === 'full' && drawers.present.quality === 'low';
    return low && this.own === SHOWN && drawers.failures <= MOST_FAILURES && !this.simple;
  }

  /** Keeps the low profile because the full one could not be prepared; with lost graphics, until they are back. */
  private keepLow(error: unknown): void {
    if (this.scene.isLost) return;
    if (!(error instanceof TooSlow)) throw error;
    this.simplify(error.ms);
  }

  /** Gives the full profile up for good, because a picture took, or would take, as long as `ms` [ms]. */
  private simplify(ms: number): void {
    if (this.simple) return;
    this.simple = true;
    this.full.end();
    if (this.drawers.present.quality === 'full') {
      this.putting.stop();
      this.drawers.renew();
    }
    const why = `Low detail: a full picture takes ${(ms / 1000).toFixed(1)} s here`;
    for (const picture of this.monitors.both.flatMap(({ halves }) => halves)) picture.setPreparing(why);
    setTimeout(() => this.setPreparing(null), NOTICE_MS);
    this.listener.simplified?.(why);
  }

  private get manner(): Manner {
    const { exaggerated, plane, round } = this;
    return { exaggerated, plane, round };
  }

  private drawNow(frames: PictureFrames, begun: number): Drawn {
    const { frame } = frames;
    const gap = drawnGap(frame);
    const { manner } = this;
    const stage = (shown: Frame) => this.staging.change(shown, manner);
    this.staging.set(frame, manner, performance.now());
    this.scene.setLighting(frame.display.lighting, frame.time_s); // of all pictures, also of those with other frames
    this.last = frame;
    this.begin(frame, gap);
    if (this.listener.offered) this.offers.look(frame, gap, this.survey);
    this.count += 1;
    this.own += 1;
    const all = this.panes.all(this.open, this.seventies);
    const [panes, flat] = [all.filter(({ polygons }) => !polygons), all.filter(({ polygons }) => polygons)];
    const views = this.viewsOf(all);
    const viewsFor = (some: readonly Pane[]) => some.flatMap((pane) => views.get(pane) ?? []);
    this.wantPolygons(viewsFor(flat));
    const wiped = this.panes.takeLayout(all, this.open);
    if (wiped) {
      this.scene.wipe();
      this.fineness.forget();
    }
    const metered = panes.every(({ camera }) => !this.scene.metering(camera.name));
    const { refines } = this.scene;
    // `state` contains the exposures of the low profile.
    const look = (name: string) => {
      const stops = refines ? 0 : this.scene.stops(name);
      return frames.differ ? `${stops} ${linkOf(frames.of(name)).step}` : stops;
    };
    const state = this.stateOf(frame, gap, panes, metered, begun);
    const drawn = this.panes.due(panes, state, look, this.open, this.count, wiped);
    const { early } = this.appearance;
    const stageFor = ({ camera }: View) => stage(frames.of(camera));
    const lively = early || frames.differ;
    const final = this.fineness.draw(
      this.scene,
      state,
      viewsFor(drawn.due),
      viewsFor(panes),
      lively,
      stageFor,
    );
    stage(frame);
    if (this.open) this.showAll(frame, gap, wiped);
    this.scene.send();
    const show = () => {
      const now = performance.now();
      this.fineness.shown(begun, now);
      if (!this.panes.isLaidOut(all, this.open)) return false; // the layout has changed: all will be drawn again
      for (const [{ picture, pane, polygons }, view] of views) {
        const shown = frames.of(view.camera);
        const { step } = linkOf(shown);
        stage(shown);
        if (picture)
          overlay(this.scene, picture, view, {
            frame: shown,
            gap: drawnGap(shown),
            caution: isCaution(shown),
            oneJoint: this.survey.drivesOneJoint(shown),
          });
        if (polygons) pane.show(this.listener.polygons?.at(view.camera, step) ?? null, step, freeSize(view));
        else pane.hide();
      }
      stage(frame);
      this.onPage = frames;
      const { canvas } = this;
      // Older browsers lack this function; they only miss a hidden canvas.
      const visible = canvas.checkVisibility?.({ visibilityProperty: true, opacityProperty: true }) ?? true;
      this.drawers.drawn(visible && canvas.clientWidth > 0 && canvas.clientHeight > 0);
      return !this.drawers.fault;
    };
    return { complete: drawn.complete && metered && final, show };
  }

  /** Returns a text that changes with everything in the pictures; in the full profile not with exposures. */
  private stateOf(
    frame: Frame,
    gap: ClosestPoints | null,
    panes: readonly Pane[],
    metered: boolean,
    now: number,
  ): string {
    const { early } = this.appearance;
    const look = `${this.orbits} ${this.plane} ${this.exaggerated} ${early} ${this.seventies}`;
    if (!this.scene.refines) return `${frame.tick} ${look}`;
    // Television has noise, and a picture without a metered exposure changes when it has one: neither is at rest.
    const moment = early || !metered ? frame.tick : '';
    const { lighting, ahead } = frame.display;
    const { clearance_level } = frame.work;
    const cameras = panes.map(({ camera: { name } }) => name);
    const stops = cameras.map((name) => this.scene.stops(name));
    const rest = [look, moment, clearance_level, JSON.stringify(lighting), this.scene.haunting, ahead?.held];
    return this.fineness.look(frame, gap, stops, [...rest, ...cameras].join(), now);
  }

  /** Gives the present drawer up. */
  private fail(error: unknown): void {
    this.putting.stop();
    this.full.end();
    this.drawers.failed(error, performance.now());
    if (typeof error !== 'string') console.error(error);
  }

  /** Writes time codes and clearances of the pictures that are on the page. */
  setTime({ units }: Pick<DeskView, 'units'>): void {
    const { onPage } = this;
    if (!onPage) return;
    for (const picture of this.monitors.both.flatMap(({ pictures }) => pictures)) {
      const frame = onPage.of(picture.camera.name);
      const [gap, { nearest }] = [drawnGap(frame), frame.work];
      picture.setTime(frame, this.exaggerated && picture.polygons.hidden);
      if (!gap || !nearest) continue;
      if (onPage.differ) this.staging.change(frame, this.manner);
      const seen = this.scene.sight.ends(picture.camera, gap.point_a, gap.point_b);
      picture.setGapText(`${small(nearest.clearance, units.gap)} ${units.gap.name}`, seen);
    }
    if (onPage.differ && this.last) this.staging.change(this.last, this.manner);
  }

  /** Writes how old the pictures are at `now` [ms]; `age`: ages of the scene's pictures. Returns that of the latest. */
  setAge(age: AgeOf, now: number): Age {
    const fresh = this.listener.recorded ? 'recorded' : 'live';
    return showAges(this.monitors, this.matrix, { age, fault: this.drawers.fault, fresh }, now);
  }

  dispose(): void {
    this.putting.stop();
    this.full.end();
    this.ended.abort();
    this.listener.polygons?.dispose();
    this.scene.dispose();
  }

  /** Chooses the monitors' cameras at the first frame. */
  private begin(frame: Frame, gap: ClosestPoints | null): void {
    if (this.monitors.chosen) return;
    this.survey.open(frame, gap);
    this.monitors.begin(this.survey.first(frame));
  }

  /** For each monitor and the view of all cameras, whether it has the look of 1972. */
  get seventies(): Seventies {
    return this.listener.polygons ? this.appearance.seventies : [false, false, false];
  }

  private toggleSeventies(index: 0 | 1 | typeof ALL): void {
    const [first, second, all] = this.appearance.seventies.map((on, i) => on !== (i === index));
    this.appearance.set({ seventies: [first === true, second === true, all === true] });
  }

  /** Asks the station for the pictures in the look of 1972, and marks the monitors that have it. */
  private wantPolygons(flat: readonly View[]): void {
    this.monitors.both.forEach((monitor, i) => {
      monitor.setSeventies(this.seventies[i] === true);
    });
    this.matrix.setSeventies(this.seventies[ALL]);
    const shown = flat.map((view) => [view.camera, freeSize(view)] as const);
    const sized = shown.filter(([, { width, height }]) => width >= 1 && height >= 1);
    this.listener.polygons?.want(
      sized.map(([camera, { width, height }]) => ({
        ...{ camera, aspect: Math.min(width / height, ASPECT) },
        eye: this.freeEye(camera),
      })),
    );
  }

  /** The eye of an engineering view; null for another camera, whose place the station knows. */
  private freeEye(name: string): FreeEye | null {
    const camera = this.welcome.cameras.find((one) => one.name === name);
    return camera?.kind === 'engineering' ? this.scene.sight.eye(camera) : null;
  }

  /** Returns the views of the panes; a later one may cover an earlier one. */
  private viewsOf(all: readonly Pane[]): ReadonlyMap<Pane, View> {
    const rects = all.map(({ element }) => this.panes.rectOf(element));
    const views = all.map((pane, i): [Pane, View] => {
      const rect = present(rects[i], 'the place of a picture');
      // All cameras have places of their own; of the monitors, the second may cover the first.
      const free = this.open ? WHOLE : freePart(rect, rects.slice(i + 1));
      const { camera } = pane;
      return [
        pane,
        { camera: camera.name, rect, free, early: this.appearance.early && camera.kind === 'camera' },
      ];
    });
    return new Map(views);
  }

  private showAll(frame: Frame, gap: ClosestPoints | null, wiped: boolean): void {
    const monitors = this.monitors.both.map(({ label, pictures }) => ({
      label,
      cameras: pictures.map(({ camera }) => camera),
    }));
    this.all.show({ frame, gap, monitors, count: this.count, wiped }, (element) =>
      this.panes.rectOf(element),
    );
  }
}

/** The two monitors, all cameras at once, and the one canvas behind them. */

import type { Turning } from '../input/camera-hand';
import type { Age } from '../link/delay-line';
import type { Camera, ClosestPoints, Frame, Level, Welcome } from '../link/protocol';
import { Appearance } from '../page/appearance';
import { keeper } from '../page/local-storage';
import type { Drawing } from '../page/quality';
import { inset } from '../page/width';
import { FARTHEST } from '../panel/clearance/gap-scale';
import { Matrix } from '../panel/monitors/matrix';
import { Monitor } from '../panel/monitors/monitor';
import type { Picture } from '../panel/monitors/picture';
import { el, setClass } from '../panel/parts/dom';
import type { View as DeskView } from '../panel/parts/part';
import { Scene } from '../scene';
import type { DrawnBody } from '../scene/bodies';
import type { Rect, View } from '../scene/drawn';
import { small } from '../words/format';
import { AllCameras } from './all-cameras';
import { TARGETS, type Target } from './best-pair';
import { Survey } from './coverage';
import { overlay } from './overlay';

/** Colours of the gap's line, as `--caution` and `--ink`. */
const [CAUTION, CALM] = ['#ffb534', '#d9dbdc'];
/** Pictures are drawn each so many times that the page is: MON 1, MON 2, a tile, the plan. */
const PACES = { full: [1, 1, 3, 8], low: [1, 2, 6, 24] } as const;
/** A digit pressed again within this time is that of the second bank [ms]. */
const AGAIN_MS = 700;
const BANK = 10;
/** Pictures on their way to the page are looked for so often [ms]. */
const LOOK_MS = 3;

/** A picture on the canvas. */
interface Pane {
  readonly camera: Camera;
  readonly element: HTMLElement;
  readonly pace: number;
  /** On a monitor; null: a tile. */
  readonly picture: Picture | null;
}

export interface PicturesListener {
  /** A monitor shall be shown in a window of its own (0, 1), or all cameras. */
  tearOff?: (what: 0 | 1 | 'matrix') => void;
  /** All cameras are shown, or no longer. */
  opened?: (matrix: boolean) => void;
  /** Dragging a picture turns its camera. */
  turns?: boolean;
  /** A monitor shows another camera, or is split. */
  changed?: () => void;
}

export class Pictures {
  readonly canvas = el('canvas', { class: 'scene', 'aria-hidden': 'true' });
  readonly monitors: readonly [Monitor, Monitor];
  readonly matrix: Matrix;
  readonly appearance = new Appearance(keeper, ({ night }) =>
    setClass(document.documentElement, 'night', night),
  );
  private readonly ended = new AbortController();
  private readonly scene: Scene;
  private readonly survey: Survey;
  private readonly cameras: readonly Camera[];
  private readonly all: AllCameras;
  private readonly paces: readonly [number, number, number, number];
  private readonly stamps = new WeakMap<HTMLElement, string>();
  private inHand = 0;
  private plane = false;
  private slowly = false;
  private open = false;
  private chosen = false;
  private count = 0;
  private orbits = 0;
  /** What the engineering views go round: what is there to see; null: the place where they began. */
  private round: Target | null = null;
  private layout = '';
  private digit = { index: -1, at: 0 };
  /** Does what is left to do once the pictures drawn last are on the page. */
  private finish: (() => void) | null = null;
  private looking = 0;

  constructor(
    welcome: Welcome,
    drawing: Drawing,
    private readonly listener: PicturesListener = {},
  ) {
    const { cameras } = welcome;
    const [first] = cameras;
    if (!first) throw new Error(`The scenario ${welcome.scenario} has no camera.`);
    this.cameras = cameras;
    this.paces = PACES[drawing.quality];
    const { tearOff } = listener;
    const monitor = (index: 0 | 1) =>
      new Monitor(`MON ${index + 1}`, cameras, first, {
        taken: (half) => this.take(index, half),
        choose: (camera) => this.choose(camera),
        split: () => this.toggleSplit(),
        slow: () => this.toggleSlow(),
        round: () => this.turnRound(),
        orbited: (camera, ...by) => this.orbit(camera, ...by),
        turns: listener.turns ?? false,
        ...(tearOff ? { tearOff: () => tearOff(index) } : {}),
      });
    this.monitors = [monitor(0), monitor(1)];
    this.matrix = new Matrix(cameras, {
      chosen: (camera) => this.choose(camera),
      ...(tearOff ? { tearOff: () => tearOff('matrix') } : {}),
    });
    this.take(0);
    this.appearance.follow(this.ended.signal);
    this.scene = new Scene(this.canvas, welcome, drawing);
    this.survey = new Survey(this.scene, welcome);
    this.all = new AllCameras(this.matrix, this.scene, this.survey, cameras, this.paces[3]);
  }

  /** The monitor that camera keys act on. */
  get hand(): Monitor {
    return this.monitors[this.inHand === 0 ? 0 : 1];
  }

  /** The camera that camera keys act on. */
  get camera(): Camera {
    return this.hand.picture.camera;
  }

  /** How a drag or the wheel pushes the switches of the camera in hand. */
  get turning(): Turning {
    return this.hand.picture.turning(performance.now());
  }

  /** Lets go of what is dragged. */
  release(): void {
    for (const picture of this.monitors.flatMap(({ halves }) => halves)) picture.release();
  }

  /** The drives turn at their low speed. */
  get slow(): boolean {
    return this.slowly;
  }

  /** What the monitors show, by name. */
  get shown(): readonly (readonly string[])[] {
    return this.monitors.map(({ pictures }) => pictures.map(({ camera }) => camera.name));
  }

  /** How a camera's picture is exposed [stops over full sunlight]. */
  stops({ name }: Camera): number {
    return this.scene.stops(name);
  }

  /** How often an engineering view was moved. */
  get moved(): number {
    return this.orbits;
  }

  /** All cameras are shown in place of the monitors. */
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

  /** Puts a camera on the monitor in hand; from among all cameras the monitors come back. */
  choose(camera: Camera): void {
    this.hand.choose(camera);
    this.chosen = true;
    if (this.open) this.showMatrix(false);
    this.listener.changed?.();
  }

  /** The camera of a digit on the monitor in hand; of the digit pressed again, that of the second bank. */
  chooseDigit(index: number, now: number): void {
    const again = index === this.digit.index && now - this.digit.at < AGAIN_MS;
    this.digit = { index: again ? -1 : index, at: now };
    const camera = this.cameras[again ? index + BANK : index];
    if (camera) this.choose(camera);
  }

  step(by: number): void {
    this.hand.step(by);
    this.chosen = true;
    this.listener.changed?.();
  }

  /** Shows other cameras on a monitor: one, or two halves; a monitor that shows them already is left alone. */
  show(index: number, names: readonly string[]): void {
    const monitor = this.monitors[index === 0 ? 0 : 1];
    if (this.shown[index]?.join() === names.join()) return;
    monitor.show(names);
    this.chosen = true;
    this.take(this.inHand);
    this.listener.changed?.();
  }

  takeMonitor(index: 0 | 1): void {
    this.take(index);
  }

  /** The next picture in hand: the other half of a split monitor, then the other monitor. */
  takeOther(): void {
    const { hand } = this;
    if (hand.split && hand.picture === hand.halves[0]) this.take(this.inHand, 1);
    else this.take(1 - this.inHand, 0);
  }

  toggleSplit(): void {
    this.hand.toggleSplit();
    this.take(this.inHand);
    this.listener.changed?.();
  }

  toggleSlow(): void {
    this.slowly = !this.slowly;
    for (const monitor of this.monitors) monitor.setSlow(this.slowly);
  }

  toggleMatrix(): void {
    this.showMatrix(!this.open);
  }

  showMatrix(on: boolean): void {
    this.open = on;
    this.listener.opened?.(on);
  }

  /** Moves an engineering view: round to the right and upwards [rad], or aside, and nearer by a factor. */
  orbit({ name }: Camera, right: number, upwards: number, nearer: number, aside = false): void {
    this.orbits += 1;
    this.scene.orbit(name, right, upwards, nearer, aside || this.slowly);
  }

  /** The engineering views go round the next of: where they began, the tip, the payload, the narrowest gap. */
  private turnRound(): void {
    const all = [null, ...TARGETS];
    this.round = all[(all.indexOf(this.round) + 1) % all.length] ?? null;
    this.orbits += 1;
    this.scene.turnTo(null);
    for (const monitor of this.monitors) monitor.setRound(this.round);
  }

  /** Shows or hides the separating plane; returns whether it is shown now. */
  togglePlane(): boolean {
    this.plane = !this.plane;
    return this.plane;
  }

  /** The pictures drawn last are not on the page yet; until then no others are begun. */
  get drawing(): boolean {
    return this.finish !== null;
  }

  /**
   * Draws what is due; true: all that is shown will be of this frame.
   *
   * @param clearance what the narrowest gap calls for.
   * @param done called once it is on the page, if that is still laid out as it was.
   */
  draw(frame: Frame, clearance: Level, done: () => void): boolean {
    const caution = clearance !== 'info';
    const gap = drawnGap(frame);
    this.scene.setPoses(frame.display.poses);
    this.scene.setViews(frame.views);
    const round = this.round && this.survey.place(this.round, gap);
    if (round) this.scene.follow(round);
    this.scene.setLighting(frame.display.lighting, frame.time_s);
    this.scene.setGap(gap, caution ? CAUTION : CALM, this.plane);
    const { ahead } = frame.display;
    this.scene.setGhost(ahead?.held && ahead.moves ? ahead.poses : null);
    this.begin(frame, gap);
    this.count += 1;
    const panes = this.panes();
    const wiped = this.wipe(panes);
    const state = `${frame.tick} ${this.orbits} ${this.plane} ${this.appearance.early}`;
    const look = ({ camera: { name } }: Pane) => `${name} ${this.scene.stops(name)}`;
    // A picture that lies in another one is drawn whenever that is.
    const looks = this.inset ? panes.map(look).join() : null;
    const due: (readonly [Pane, View])[] = [];
    let complete = true;
    panes.forEach((pane, i) => {
      const { name } = pane.camera;
      const stamp = `${state} ${looks ?? look(pane)}`;
      if (this.scene.metering(name)) complete = false;
      if (this.stamps.get(pane.element) === stamp && !wiped) return;
      if ((this.count + i) % pane.pace !== 0 && !wiped) {
        complete = false;
        return;
      }
      this.stamps.set(pane.element, stamp);
      const early = this.appearance.early && pane.camera.kind === 'camera';
      due.push([pane, { camera: name, rect: this.rectOf(pane.element), early }]);
    });
    this.scene.draw(due.map(([, view]) => view));
    if (this.open) this.showAll(frame, gap, wiped);
    this.scene.send();
    this.finish = () => {
      if (this.laidOut(panes) !== this.layout) return; // they are of a window that has changed, and drawn anew
      for (const [{ picture }, view] of due)
        if (picture) overlay(this.scene, picture, view, { frame, gap, caution });
      done();
    };
    this.put();
    return complete;
  }

  /** Puts the pictures on the page with what is written over them, or looks again soon. */
  private put(): void {
    const { finish } = this;
    if (!finish) return;
    if (!this.scene.put()) {
      this.looking = window.setTimeout(() => this.put(), LOOK_MS);
      return;
    }
    this.finish = null;
    finish();
  }

  /** Time codes and figures; `age` of the picture, null where it is a recorded one. */
  setTime({ frame, units }: Pick<DeskView, 'frame' | 'units'>, age: Age | null): void {
    const [gap, { nearest }] = [drawnGap(frame), frame.work];
    for (const picture of this.monitors.flatMap(({ pictures }) => pictures)) {
      picture.setTime(frame, age);
      if (!gap || !nearest) continue;
      const seen = this.scene.sight.ends(picture.camera, gap.point_a, gap.point_b);
      picture.setGapText(`${small(nearest.clearance, units.gap)} ${units.gap.name}`, seen);
    }
    if (this.open) this.matrix.setAge(age);
  }

  dispose(): void {
    clearTimeout(this.looking);
    this.ended.abort();
    this.scene.dispose();
  }

  /** At the first frame, the monitors show what the work needs. */
  private begin(frame: Frame, gap: ClosestPoints | null): void {
    if (this.chosen) return;
    this.chosen = true;
    this.survey.lookAll(frame, gap);
    this.survey.first(frame).forEach((camera, i) => {
      this.monitors[i === 0 ? 0 : 1].choose(camera);
    });
    this.listener.changed?.();
  }

  /** MON 2 lies in a corner of MON 1. */
  private get inset(): boolean {
    return inset() && !this.open && this.monitors.every(({ element }) => element.isConnected);
  }

  /** The pictures on the page. */
  private panes(): readonly Pane[] {
    const [first, second, tile] = this.paces;
    if (this.open) {
      return this.matrix.tiles.map(({ camera, picture }) => ({
        camera,
        element: picture,
        pace: tile,
        picture: null,
      }));
    }
    return this.monitors.flatMap(({ element, pictures }, i) =>
      element.isConnected
        ? pictures.map((picture) => {
            const alone = i === 0 || !this.monitors[0].element.isConnected;
            const pace = alone || this.inset ? first : second;
            return { camera: picture.camera, element: picture.element, pace, picture };
          })
        : [],
    );
  }

  /** What the pictures' places on the page depend on. */
  private laidOut(panes: readonly Pane[]): string {
    const { clientWidth, clientHeight } = this.canvas;
    return [clientWidth, clientHeight, this.open, ...panes.map(({ element }) => element.clientWidth)].join();
  }

  /** Wipes the canvas where pictures have come, gone or moved; returns whether they have. */
  private wipe(panes: readonly Pane[]): boolean {
    const layout = this.laidOut(panes);
    if (layout === this.layout) return false;
    this.layout = layout;
    this.scene.wipe();
    return true;
  }

  private rectOf(element: HTMLElement): Rect {
    const over = this.canvas.getBoundingClientRect();
    const { left, top, width, height } = element.getBoundingClientRect();
    return { left: left - over.left, top: top - over.top, width, height };
  }

  private showAll(frame: Frame, gap: ClosestPoints | null, wiped: boolean): void {
    const monitors = this.monitors.map(({ label, pictures }) => ({
      label,
      cameras: pictures.map(({ camera }) => camera),
    }));
    this.all.show({ frame, gap, monitors, count: this.count, wiped }, (element) => this.rectOf(element));
  }

  private take(index: number, half?: number): void {
    this.inHand = index;
    this.monitors.forEach((monitor, i) => {
      const own = monitor.halves.indexOf(monitor.picture);
      monitor.setInHand(i === index ? (half ?? own) : null);
    });
  }
}

/** The gap that is worth a line: none that is wide, none where the two touch. */
export function drawnGap({ work: { nearest }, display: { gap } }: Frame): ClosestPoints | null {
  return nearest && nearest.clearance > 0 && nearest.clearance < FARTHEST ? gap : null;
}

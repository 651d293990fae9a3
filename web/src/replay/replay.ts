/** The page of a replay: monitors, summary values of the run, and below them the time axis. It follows the playhead. */

import { Pictures } from '../cameras/pictures';
import { Displayed } from '../link/age';
import { Frames } from '../link/frames';
import { PictureFrames } from '../link/picture-frames';
import type { Frame, PlaybackIndex } from '../link/protocol';
import { publish } from '../page/hook';
import type { Drawing } from '../page/quality';
import { el, setClass } from '../panel/parts/dom';
import { BLOCKED, type Torn, tearOff } from '../windows/opened';
import { ShownUnits } from '../words/units';
import { FlownDesk } from './desk';
import { eventBeside, eventsUntil } from './event-steps';
import { FlownCameras } from './flown-cameras';
import { FlownChanges } from './flown-changes';
import { listen } from './keys';
import { Player } from './player';
import { replayRail } from './rail';
import { RecordedPolygons } from './recorded-polygons';
import { RunColumn } from './run';
import { flyingHere, type Source } from './source';
import { STEP } from './span';
import { Timeline } from './timeline';
import { Transport } from './transport';
import { pollVerdict } from './verdict';
import { ReplayWindows } from './windows';

/** Time between two updates of the numbers [ms]. */
const VALUES_MS = 100;
/** Greatest time by which the playhead advances between two pictures, even if the browser paused for longer [s]. */
const LONGEST_STEP_S = 0.25;
/** Time for which the page displays that a window was blocked [ms]. */
const BLOCKED_MS = 8000;

export class Replay {
  private drawn = 0;
  /** The latest frame that both the pictures and the read-outs have displayed. */
  private shown: Frame | null = null;
  /** The latest frame that the read-outs have displayed. */
  private figures: Frame | null = null;
  private readonly units: ShownUnits;
  private before = performance.now();
  private valuesAt = 0;
  private pictured = '';
  /** Whether all pictures show the frame at the playhead. */
  private complete = false;
  private blockedUntil = 0;
  /** The frames at the playhead, and how long the pictures have not shown them. */
  private readonly frames: Frames;
  private readonly displayed: Displayed;
  private readonly windows: ReplayWindows;
  private readonly player: Player;
  /** Pictures in the look of 1972; null if nothing computes them. */
  private readonly polygons: RecordedPolygons | null;
  private readonly pictures: Pictures;
  private readonly cameras: FlownCameras;
  private readonly timeline: Timeline;
  private readonly changes: FlownChanges;
  private readonly transport: Transport;
  private readonly run: RunColumn;
  private readonly rail;
  private readonly desk: FlownDesk;
  private readonly band: HTMLElement;

  constructor(
    root: HTMLElement,
    drawing: Drawing,
    source: Source,
    private readonly index: PlaybackIndex,
  ) {
    this.units = new ShownUnits(index.welcome.units);
    this.changes = new FlownChanges(index);
    this.frames = new Frames(index.welcome.control_period_s);
    this.displayed = new Displayed(this.frames, 'camera');
    this.player = new Player(index, (number) => source.block(number));
    this.polygons = source.polygons ? new RecordedPolygons(source.polygons) : null;
    this.pictures = new Pictures(index.welcome, drawing, {
      recorded: true,
      ...(this.polygons ? { polygons: this.polygons } : {}),
      opened: (matrix) => setClass(root, 'all-cameras', matrix),
      tearOff: (what) => this.tearOff(what),
      changed: () => {
        this.cameras.changed();
        this.windows.tell();
      },
    });
    this.cameras = new FlownCameras(index.pictures, this.pictures.monitors);
    const { cameras } = index.welcome;
    this.windows = new ReplayWindows(this.player, this.pictures, cameras, () => this.units.name);
    this.timeline = new Timeline(index, this.player.duration, (position) => this.player.seek(position));
    this.transport = new Transport(index, this.player, {
      event: (by) => this.toEvent(by),
      strips: (names) => this.timeline.choose(names),
      desk: () => this.showDesk(),
      asFlown: () => this.showAsFlown(),
      zoom: (way) => this.zoom(way),
      tearOff: (what) => this.tearOff(what),
    });
    this.run = new RunColumn(index);
    this.desk = new FlownDesk(index);
    this.rail = replayRail(index, flyingHere(document), () => {
      this.units.toggle();
      this.windows.tell();
    });
    const [first, second] = this.pictures.monitors.both;
    this.band = el(
      'section',
      { class: 'band', 'aria-label': 'Time' },
      this.transport.element,
      this.timeline.element,
      this.desk.element,
    );
    root.classList.add('replay');
    root.replaceChildren(
      this.pictures.canvas,
      el('main', { class: 'monitors' }, first.element, second.element, this.run.element),
      this.pictures.matrix.element,
      this.band,
      this.rail.element,
    );
    document.title = `${index.file} · Aftdeck`;
    listen(this.player, {
      event: (by) => this.toEvent(by),
      desk: () => this.showDesk(),
      camera: (number) => this.pictures.monitors.chooseDigit(number, performance.now()),
      stepCamera: (by) => this.pictures.monitors.step(by),
      matrix: () => this.pictures.toggleMatrix(),
      split: () => this.pictures.monitors.toggleSplit(),
      otherMonitor: () => this.pictures.monitors.takeOther(),
      plane: () => {
        this.desk.setPlane(this.pictures.togglePlane());
        this.windows.tell();
      },
      bending: () => {
        if (index.welcome.flexures.length > 0) this.desk.setBending(this.pictures.toggleBending());
        this.windows.tell();
      },
      asFlown: () => this.showAsFlown(),
      zoom: (way) => this.zoom(way),
      close: () => this.transport.open(false),
    });
    this.rail.setVerdict(index.verdict);
    if (index.verdict.state === 'checking') pollVerdict(source, (verdict) => this.rail.setVerdict(verdict));
    publish(drawing.renderer, () => ({
      frames: this.drawn,
      lastFrame: this.shown,
      restarts: 0,
      bodies: this.pictures.bodies,
      sharpness: this.pictures.sharpness,
      latency95: null,
    }));
    setInterval(() => this.showAge(performance.now()), VALUES_MS);
    this.tick();
  }

  /** Shows at `now` [ms] whether the pictures are old, even if nothing is drawn. */
  private showAge(now: number): void {
    if (document.hidden) this.displayed.displayed(now);
    this.pictures.setAge(() => this.displayed.age(now), now);
  }

  private tick(): void {
    requestAnimationFrame(() => this.tick());
    const now = performance.now();
    this.player.advance(Math.min((now - this.before) / 1000, LONGEST_STEP_S));
    this.before = now;
    this.windows.tellHead();
    const { moment, position } = this.player;
    const { units } = this.units;
    if (moment && this.changes.show(moment.frame.tick)) {
      this.pictures.renew();
      this.pictured = '';
    }
    if (moment) this.frames.put(moment.frame, now);
    if (this.pictures.lost) this.complete = false;
    if (moment && !this.pictures.drawing && (this.isNew(moment.frame) || !this.complete)) {
      this.desk.bars(moment.frame, units);
      this.cameras.show(position);
      const { frame } = moment;
      this.complete = this.pictures.draw(new PictureFrames(frame), () => {
        this.pictures.setTime({ units });
        this.displayed.displayed(performance.now());
        this.drawn += 1;
        this.shown = this.figures;
      });
    } else if (this.complete && !this.pictures.drawing) this.displayed.displayed(now); // the pictures show this frame
    this.timeline.show(position, moment, units);
    if (now - this.valuesAt >= VALUES_MS) {
      this.valuesAt = now;
      const past = eventsUntil(this.index.events, position);
      this.run.show(past, units);
      this.rail.setUnits(units);
      if (moment) {
        this.desk.values(moment.frame, units, past);
        this.figures = moment.frame;
        if (!this.pictures.drawing) this.shown = this.figures;
      }
      const message = this.player.failure || (now < this.blockedUntil ? BLOCKED : '');
      this.transport.show(message, message !== '');
      this.transport.setFollowing(this.cameras.state);
      this.transport.setZoomed(this.timeline.isZoomed);
    }
  }

  /** Returns whether the pictures must be drawn again, because the frame, a camera, the look or the window's size has changed. */
  private isNew(frame: Frame): boolean {
    const { canvas, monitors, seventies, showsPlane, exaggerates, matrixOpen, moved } = this.pictures;
    const { clientWidth, clientHeight } = canvas;
    const state = [
      frame.tick,
      clientWidth,
      clientHeight,
      showsPlane,
      exaggerates,
      matrixOpen,
      moved,
      ...seventies,
      this.polygons?.received,
      ...monitors.shown,
    ].join();
    if (state === this.pictured) return false;
    this.pictured = state;
    return true;
  }

  private showAsFlown(): void {
    this.cameras.reset();
    this.pictured = '';
  }

  private zoom(way: 1 | -1): void {
    this.timeline.zoom(way > 0 ? STEP : 1 / STEP, this.player.position);
  }

  private toEvent(by: 1 | -1): void {
    const event = eventBeside(this.index.events, this.player.position, by);
    if (event) this.player.seek(event.time_s);
  }

  private showDesk(): void {
    const on = !this.band.classList.contains('with-desk');
    setClass(this.band, 'with-desk', on);
    this.transport.setDesk(on);
  }

  private tearOff(what: Torn): void {
    if (!tearOff(what)) this.blockedUntil = performance.now() + BLOCKED_MS;
  }
}

/** Playing a recording: the monitors, the run's figures, and time below them; drawn as the playhead moves. */

import { Pictures } from '../cameras/pictures';
import type { Frame, PlaybackIndex } from '../link/protocol';
import { publish } from '../page/hook';
import { notice } from '../page/notice';
import type { Drawing } from '../page/quality';
import { el, setClass } from '../panel/parts/dom';
import { BLOCKED, type Torn, tearOff, tornHere } from '../windows/opened';
import { type UnitName, unitsOf } from '../words/units';
import { FlownDesk } from './desk';
import { listen } from './keys';
import { Player } from './player';
import { replayRail } from './rail';
import { RunColumn } from './run';
import { follow } from './second';
import { flyingHere, type Source } from './source';
import { STEP } from './span';
import { Timeline } from './timeline';
import { Transport } from './transport';
import { ReplayWindows } from './windows';

/** Figures change this often [ms]. */
const VALUES_MS = 100;
/** A longer pause of the browser's is none of the recording's [s]. */
const LONGEST_STEP_S = 0.25;
const VERDICT_MS = 1000;
/** Time for which a blocked window is reported [ms]. */
const BLOCKED_MS = 8000;
/** Greatest time between the playhead and its event [s]. */
const AT = 1e-3;

/** Fills the page with a recording, or says why it cannot be played. */
export function play(root: HTMLElement, drawing: Drawing, source: Source): void {
  notice(root, 'Opening the recording.');
  source.index().then(
    (index) => {
      const torn = tornHere(location.search);
      if (torn === null) new Replay(root, drawing, source, index);
      else follow(root, drawing, source, index, torn);
    },
    () => notice(root, 'The recording cannot be opened: its file or its server does not answer.'),
  );
}

class Replay {
  private drawn = 0;
  /** What pictures and figures show, and what the figures are of. */
  private shown: Frame | null = null;
  private figures: Frame | null = null;
  private units: UnitName;
  private before = performance.now();
  private valuesAt = 0;
  private pictured = '';
  /** All pictures are of the frame at the playhead. */
  private complete = false;
  /** The reader chose what the monitors show; until then they show what they showed in flight. */
  private chosen = false;
  private following = false;
  private blockedUntil = 0;
  private readonly windows: ReplayWindows;
  private readonly player: Player;
  private readonly pictures: Pictures;
  private readonly timeline: Timeline;
  private readonly transport: Transport;
  private readonly run: RunColumn;
  private readonly rail;
  private readonly desk: FlownDesk;
  private readonly band: HTMLElement;

  constructor(
    root: HTMLElement,
    drawing: Drawing,
    private readonly source: Source,
    private readonly index: PlaybackIndex,
  ) {
    this.units = index.welcome.units;
    this.player = new Player(index, (number) => source.block(number));
    this.pictures = new Pictures(index.welcome, drawing, {
      opened: (matrix) => setClass(root, 'all-cameras', matrix),
      tearOff: (what) => this.tearOff(what),
      changed: () => {
        this.chosen ||= !this.following;
        this.windows.tell();
      },
    });
    const { cameras } = index.welcome;
    this.windows = new ReplayWindows(this.player, this.pictures, cameras, () => this.units);
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
      this.units = this.units === 'SI' ? 'ft-in' : 'SI';
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
      asFlown: () => this.showAsFlown(),
      zoom: (way) => this.zoom(way),
      close: () => this.transport.open(false),
    });
    this.rail.setVerdict(index.verdict);
    if (index.verdict.state === 'checking') this.judge();
    publish(drawing.renderer, () => ({
      frames: this.drawn,
      lastFrame: this.shown,
      restarts: 0,
      bodies: this.pictures.bodies,
      latency95: null,
    }));
    this.tick();
  }

  private tick(): void {
    requestAnimationFrame(() => this.tick());
    const now = performance.now();
    this.player.advance(Math.min((now - this.before) / 1000, LONGEST_STEP_S));
    this.before = now;
    this.windows.tellHead();
    const { moment, position } = this.player;
    const units = unitsOf(this.units);
    if (moment && !this.pictures.drawing && (this.isNew(moment.frame) || !this.complete)) {
      this.desk.bars(moment.frame, units);
      this.follow();
      const { frame } = moment;
      this.complete = this.pictures.draw(frame, frame.work.clearance_level, () => {
        this.pictures.setTime({ frame, units }, null);
        this.drawn += 1;
        this.shown = this.figures;
      });
    }
    this.timeline.show(position, moment, units);
    if (now - this.valuesAt >= VALUES_MS) {
      this.valuesAt = now;
      const past = this.past();
      this.run.show(past, units);
      this.rail.setUnits(units);
      if (moment) {
        this.desk.values(moment.frame, units, past);
        this.figures = moment.frame;
        if (!this.pictures.drawing) this.shown = this.figures;
      }
      const said = this.player.failure || (now < this.blockedUntil ? BLOCKED : '');
      this.transport.show(said, said !== '');
      this.transport.setFollowing(this.tellsPictures ? !this.chosen : null);
      this.transport.setZoomed(this.timeline.isZoomed);
    }
  }

  /** True if the pictures have to change: another frame, camera, or window. */
  private isNew(frame: Frame): boolean {
    const { canvas, monitors, showsPlane, matrixOpen, moved } = this.pictures;
    const { clientWidth, clientHeight } = canvas;
    const asked = [
      frame.tick,
      clientWidth,
      clientHeight,
      showsPlane,
      matrixOpen,
      moved,
      ...monitors.shown,
    ].join();
    if (asked === this.pictured) return false;
    this.pictured = asked;
    return true;
  }

  /** The monitors as they were in flight, until one is chosen. */
  private follow(): void {
    if (this.chosen) return;
    const { pictures } = this.index;
    const flown = pictures.findLast(({ time_s }) => time_s <= this.player.position + AT) ?? pictures[0];
    this.following = true;
    flown?.monitors.forEach((names, i) => {
      if (names.length > 0) this.pictures.monitors.show(i, names);
    });
    this.following = false;
  }

  /** The monitors go back to the recording's cameras. */
  private showAsFlown(): void {
    this.chosen = false;
    this.pictured = '';
  }

  private get tellsPictures(): boolean {
    return this.index.pictures.some(({ monitors }) => monitors.some((names) => names.length > 0));
  }

  private zoom(way: 1 | -1): void {
    this.timeline.zoom(way > 0 ? STEP : 1 / STEP, this.player.position);
  }

  /** Events up to the playhead. */
  private past(): number {
    const { events } = this.index;
    const after = events.findIndex(({ time_s }) => time_s > this.player.position + AT);
    return after < 0 ? events.length : after;
  }

  private toEvent(by: 1 | -1): void {
    const { position } = this.player;
    const { events } = this.index;
    const next =
      by > 0
        ? events.find(({ time_s }) => time_s > position + AT)
        : events.findLast(({ time_s }) => time_s < position - AT);
    if (next) this.player.seek(next.time_s);
  }

  private showDesk(): void {
    const on = !this.band.classList.contains('with-desk');
    setClass(this.band, 'with-desk', on);
    this.transport.setDesk(on);
  }

  private tearOff(what: Torn): void {
    if (!tearOff(what)) this.blockedUntil = performance.now() + BLOCKED_MS;
  }

  /** Asks for the recomputation's result until it is known. */
  private judge(): void {
    this.source.verdict()?.then(
      (verdict) => {
        this.rail.setVerdict(verdict);
        if (verdict.state === 'checking') setTimeout(() => this.judge(), VERDICT_MS);
      },
      () => setTimeout(() => this.judge(), VERDICT_MS),
    );
  }
}

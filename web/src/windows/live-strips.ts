/** A secondary window with the last minutes of a live run as lanes and strips; the present time is at the right. */

import { Displayed, isStale } from '../link/age';
import { Frames } from '../link/frames';
import type { Frame, Event as LogEvent, Recent, Welcome } from '../link/protocol';
import { setClass } from '../panel/parts/dom';
import { minutes } from '../replay/quantity';
import type { Span } from '../replay/span';
import { unitsOf } from '../words/units';
import { KEPT_S, LastMinutes } from './last-minutes';
import { FLOWN, Tether } from './secondary-window';
import { StripWindow } from './strip-window';

/** Time between two updates of the numbers [ms]. */
const VALUES_MS = 100;
/** The curves are redrawn when they have moved by this fraction of the axis, about one pixel. */
const PIXEL = 1 / 1200;
/** Lengths of the time axis from which the user chooses [s], and the index of the initial length. */
const LENGTHS = [30, 60, 120, KEPT_S];
const FIRST = 2;

export class LiveStrips {
  readonly drawn = 0;
  readonly bodies = [];
  readonly sharpness = null;
  shown: { readonly frame: Frame | null; readonly restarts: number } = { frame: null, restarts: 0 };
  private readonly frames: Frames;
  private readonly displayed: Displayed;
  private window: StripWindow | null = null;
  private choice = FIRST;
  private span: Span = { from: 0, to: 0 };
  private asked = '';
  private readonly minutes = new LastMinutes();
  private readonly tether: Tether;
  private readonly timer: number;

  constructor(
    private readonly root: HTMLElement,
    private readonly welcome: Welcome,
  ) {
    this.frames = new Frames(welcome.control_period_s);
    this.displayed = new Displayed(this.frames, 'telemetry');
    this.tether = new Tether({ ...FLOWN, name: 'Strips', title: welcome.title }, { heard() {} });
    root.classList.add('torn-off', 'strips-live');
    root.replaceChildren(this.tether.rail);
    this.timer = window.setInterval(() => this.draw(), VALUES_MS);
  }

  setFrame(frame: Frame): void {
    this.frames.put(frame, performance.now());
  }

  setRecent(recent: Recent): void {
    this.minutes.take(recent);
    if (this.window) return;
    const timed = { lanes: [], events: [], strips: this.minutes.blank };
    this.window = new StripWindow(timed, Infinity, { sought: null, zoom: (way) => this.zoom(way) });
    this.root.append(this.window.element);
  }

  addEvents(events: readonly LogEvent[]): void {
    this.minutes.note(events);
  }

  forgetEvents(): void {
    this.minutes.forget();
  }

  dispose(): void {
    clearInterval(this.timer);
    this.tether.dispose();
    this.root.classList.remove('strips-live');
  }

  private get length(): number {
    return LENGTHS[this.choice] ?? KEPT_S;
  }

  private zoom(way: 1 | -1): void {
    this.choice = Math.min(Math.max(this.choice - way, 0), LENGTHS.length - 1);
  }

  private draw(): void {
    const { window: shown, minutes: last, choice } = this;
    const now = performance.now();
    const seen = this.frames.at('telemetry');
    if (!seen || !shown || !last.newest) return;
    const age = this.displayed.age(now);
    this.tether.showAt(seen.frame, age);
    setClass(document.body, 'stale', isStale(age));
    const units = unitsOf(this.tether.page?.units ?? this.welcome.units);
    const asked = [this.length, units.name, ...shown.chosen].join();
    const moved = last.now - this.span.to;
    if (moved >= PIXEL * this.length || moved < 0 || asked !== this.asked) {
      this.asked = asked;
      this.span = { from: last.now - this.length, to: last.now };
      shown.timeline.renew(last.over(this.span, shown.chosen, units), this.span);
    }
    shown.timeline.show(this.span.to, last.newest, units);
    shown.show(
      minutes(last.now, 1),
      ` · last ${spoken(this.length)}`,
      choice < LENGTHS.length - 1,
      choice > 0,
    );
    this.shown = seen;
    this.displayed.displayed(now);
  }
}

function spoken(seconds: number): string {
  return seconds < 60 ? `${seconds} s` : `${seconds / 60} min`;
}

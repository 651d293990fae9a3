/** A secondary window with pictures: one monitor or all cameras, of a live run or of a replay. */

import type { Sharpness } from '../cameras/fineness';
import { Pictures } from '../cameras/pictures';
import type { Action } from '../input/action';
import { Keyboard } from '../input/keyboard';
import { USES } from '../input/keymap';
import { Displayed } from '../link/age';
import { Frames } from '../link/frames';
import { PolygonPictures, type PolygonSource } from '../link/polygon-pictures';
import type { Frame, Welcome } from '../link/protocol';
import type { Drawing } from '../page/quality';
import { el } from '../panel/parts/dom';
import type { DrawnBody } from '../scene/bodies';
import { type UnitName, unitsOf } from '../words/units';
import type { PageState, Pictured, WindowMessage } from './opened';
import { FLOWN, PLAYED, Tether } from './secondary-window';

/** Time between two updates of the numbers [ms]. */
const VALUES_MS = 100;

/** The recording that is shown. */
export interface Played {
  readonly file: string;
  /** Receives the page's messages, which include the playhead. */
  heard(message: WindowMessage): void;
}

export class Display {
  drawn = 0;
  shown: { readonly frame: Frame | null; readonly restarts: number } = { frame: null, restarts: 0 };
  /** Last frame whose time the window has displayed, and the count of restarts before this frame. */
  private latest = this.shown;
  private readonly frames: Frames;
  private readonly displayed: Displayed;
  private valuesAt = 0;
  private request = 0;
  private readonly timer: number;
  /** True while the window draws or applies the page's state. Changes of cameras at such times are not sent back. */
  private hearing = false;
  private units: UnitName;
  private readonly pictures: Pictures;
  private readonly tether: Tether;
  private readonly keyboard: Keyboard;

  /** `played` is null for a live run; `polygons` is null if nothing computes the look of 1972. */
  constructor(
    root: HTMLElement,
    welcome: Welcome,
    drawing: Drawing,
    private readonly what: Pictured,
    private readonly played: Played | null = null,
    private readonly flat: PolygonSource | null = null,
  ) {
    const name = what === 'matrix' ? 'All cameras' : `MON ${what + 1}`;
    this.units = welcome.units;
    this.frames = new Frames(welcome.control_period_s);
    this.displayed = new Displayed(this.frames, 'camera');
    this.tether = new Tether(
      { ...(played ? { ...PLAYED, file: played.file } : FLOWN), name, title: welcome.title },
      {
        heard: (message) => {
          if (message.kind === 'page') this.follow(message);
          played?.heard(message);
        },
        take: () => {
          if (what !== 'matrix') this.tether.say({ kind: 'take', monitor: what });
        },
      },
    );
    this.pictures = new Pictures(welcome, drawing, {
      changed: () => this.tell(),
      recorded: played !== null,
      ...(flat ? { polygons: flat } : {}),
    });
    this.keyboard = new Keyboard({ moved() {}, acted: (action) => this.act(action), taken: () => false });
    if (what === 'matrix') this.pictures.showMatrix(true);
    else this.pictures.monitors.take(what);
    const shown =
      what === 'matrix'
        ? this.pictures.matrix.element
        : el('main', { class: 'monitors' }, this.pictures.monitors.both[what].element);
    root.classList.add('torn-off');
    root.replaceChildren(this.pictures.canvas, shown, this.tether.rail);
    this.request = requestAnimationFrame(() => this.tick());
    this.timer = window.setInterval(() => this.showAge(performance.now()), VALUES_MS);
  }

  /** Receiver of the live station's pictures in the look of 1972. */
  get polygons(): PolygonPictures | null {
    return this.flat instanceof PolygonPictures ? this.flat : null;
  }

  get bodies(): readonly DrawnBody[] {
    return this.pictures.bodies;
  }

  get sharpness(): Sharpness | null {
    return this.pictures.sharpness;
  }

  setFrame(frame: Frame): void {
    this.frames.put(frame, performance.now());
  }

  changed(): void {
    this.pictures.renew();
  }

  dispose(): void {
    cancelAnimationFrame(this.request);
    clearInterval(this.timer);
    this.tether.dispose();
    this.keyboard.dispose();
    this.pictures.dispose();
  }

  private tick(): void {
    this.request = requestAnimationFrame(() => this.tick());
    if (this.played && this.frames.newest) this.setFrame(this.frames.newest.frame); // a recording does not grow old
    const [seen, pictures] = [this.frames.at('camera'), this.frames.pictures];
    if (!seen || !pictures || this.pictures.drawing) return;
    this.hearing = true; // cameras chosen by the first drawing are not sent to the page
    const done = () => {
      this.drawn += 1;
      this.displayed.displayed(performance.now());
      this.shown = this.latest;
    };
    this.pictures.draw(pictures, done);
    this.hearing = false;
    const now = performance.now();
    if (now - this.valuesAt < VALUES_MS) return;
    this.valuesAt = now;
    this.pictures.setTime({ units: unitsOf(this.units) });
    this.latest = seen;
    if (!this.pictures.drawing) this.shown = this.latest;
  }

  /** Shows how old the pictures are at `now` [ms], even if nothing is drawn. */
  private showAge(now: number): void {
    if (document.hidden) this.displayed.displayed(now);
    const age = this.pictures.setAge((camera) => this.displayed.age(now, false, camera), now);
    const seen = this.frames.at('camera');
    if (seen) this.tether.showAt(seen.frame, age);
  }

  /** Applies the page's state. */
  private follow({ monitors, plane, bending, units }: PageState): void {
    this.hearing = true;
    this.units = units;
    if (plane !== this.pictures.showsPlane) this.pictures.togglePlane();
    if (bending !== this.pictures.exaggerates) this.pictures.toggleBending();
    monitors.forEach((names, i) => {
      this.pictures.monitors.show(i, names);
    });
    this.hearing = false;
  }

  /** Sends the user's choice to the page. */
  private tell(): void {
    if (this.hearing) return;
    const { what, pictures } = this;
    if (what === 'matrix') {
      pictures.showMatrix(true);
      this.tether.say({ kind: 'put', name: pictures.monitors.camera.name });
    } else this.tether.say({ kind: 'show', monitor: what, names: pictures.monitors.shown[what] ?? [] });
  }

  private act({ name }: Action): void {
    const does = USES.get(name)?.does;
    const { pictures } = this;
    if (does?.kind === 'view')
      does.act({
        pictures,
        togglePlane: () => pictures.togglePlane(),
        toggleBending: () => pictures.toggleBending(),
      });
  }
}

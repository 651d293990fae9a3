/** A second window: one monitor or all cameras, of the same flight, and nothing to fly with. */

import { missionTime } from './format';
import { Keyboard } from './input/keyboard';
import type { Action } from './input/keymap';
import { el, setClass, setText } from './panel/dom';
import { STALE_S } from './panel/picture';
import { Pictures } from './pictures';
import type { Frame, Welcome } from './protocol';
import type { Drawing } from './quality';
import type { DrawnBody } from './scene/bodies';
import { unitsOf } from './units';
import { type Torn, Windows } from './windows';

/** Figures change this often [ms]. */
const VALUES_MS = 100;

export class Display {
  drawn = 0;
  shown: { readonly frame: Frame | null; readonly restarts: number } = { frame: null, restarts: 0 };
  private frame: Frame | null = null;
  private restarts = 0;
  private arrived = 0;
  private valuesAt = 0;
  private request = 0;
  /** Others are not told of what they told. */
  private hearing = false;
  private readonly pictures: Pictures;
  private readonly keyboard: Keyboard;
  private readonly windows: Windows;
  private readonly met = el('b');
  private readonly state = el('span', { class: 'who', role: 'status' });

  constructor(
    root: HTMLElement,
    private readonly welcome: Welcome,
    drawing: Drawing,
    private readonly what: Torn,
  ) {
    this.windows = new Windows((said) => {
      if (said.kind !== 'shown') return;
      this.hearing = true;
      said.monitors.forEach((names, i) => {
        this.pictures.show(i, names);
      });
      this.hearing = false;
    });
    this.pictures = new Pictures(welcome, drawing, { changed: () => this.tell() });
    this.keyboard = new Keyboard({ moved() {}, acted: (action) => this.act(action), taken: () => false });
    if (what === 'matrix') this.pictures.showMatrix(true);
    else this.pictures.takeMonitor(what);
    const shown =
      what === 'matrix'
        ? this.pictures.matrix.element
        : el('main', { class: 'monitors' }, this.pictures.monitors[what].element);
    const name = what === 'matrix' ? 'All cameras' : `MON ${what + 1}`;
    root.classList.add('torn-off');
    root.replaceChildren(
      this.pictures.canvas,
      shown,
      el(
        'header',
        { class: 'rail' },
        el('h1', {}, 'Aftdeck'),
        el('span', { class: 'scenario' }, welcome.title),
        el('span', {}, name),
        el('span', { class: 'space' }),
        el('span', { class: 'met' }, 'MET ', this.met),
        this.state,
      ),
    );
    document.title = `${name} · ${welcome.title} · Aftdeck`;
    this.windows.say({ kind: 'ask' });
    this.request = requestAnimationFrame(() => this.tick());
  }

  get bodies(): readonly DrawnBody[] {
    return this.pictures.bodies;
  }

  setFrame(frame: Frame): void {
    if (this.frame && frame.tick < this.frame.tick) this.restarts += 1;
    this.frame = frame;
    this.arrived = performance.now();
  }

  dispose(): void {
    cancelAnimationFrame(this.request);
    this.keyboard.dispose();
    this.windows.dispose();
    this.pictures.dispose();
  }

  private tick(): void {
    this.request = requestAnimationFrame(() => this.tick());
    const { frame } = this;
    if (!frame) return;
    const { nearest } = frame.work;
    const { caution } = this.welcome.work;
    this.hearing = true; // what it shows at first is the other page's choice
    this.pictures.draw(frame, nearest && nearest.clearance < caution ? 'caution' : 'info');
    this.hearing = false;
    this.drawn += 1;
    const now = performance.now();
    if (now - this.valuesAt < VALUES_MS) return;
    this.valuesAt = now;
    const age = (now - this.arrived) / 1000;
    this.pictures.setTime({ frame, units: unitsOf(this.welcome.units) }, age);
    setText(this.met, missionTime(frame.time_s));
    setText(this.state, age > STALE_S ? 'Lost' : 'Watching');
    setClass(this.state, 'lost', age > STALE_S);
    this.shown = { frame, restarts: this.restarts };
  }

  /** The page that flies shows what was chosen here. */
  private tell(): void {
    if (this.hearing) return;
    const { what, pictures } = this;
    if (what === 'matrix') {
      pictures.showMatrix(true);
      this.windows.say({ kind: 'put', name: pictures.camera.name });
    } else this.windows.say({ kind: 'show', monitor: what, names: pictures.shown[what] ?? [] });
  }

  private act(action: Action): void {
    if (action.name === 'camera') this.pictures.chooseDigit(action.number - 1, performance.now());
    else if (action.name === 'cameraStep') this.pictures.step(action.by);
    else if (action.name === 'split') this.pictures.toggleSplit();
    else if (action.name === 'plane') this.pictures.togglePlane();
  }
}

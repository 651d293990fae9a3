/** A second window: one monitor or all cameras, of the same flight; its keys are the flier's, where one is in this browser. */

import { missionTime } from './format';
import { KeyRelay } from './input/key-relay';
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
  /** What the figures are of. */
  private told = this.shown;
  private frame: Frame | null = null;
  private restarts = 0;
  private arrived = 0;
  private valuesAt = 0;
  private request = 0;
  /** Others are not told of what they told. */
  private hearing = false;
  private readonly pictures: Pictures;
  /** The page of this browser that flies; null: none, and keys choose cameras here alone. */
  private flier: string | null = null;
  /** The camera keys act on this window's monitor, since it got the focus. */
  private taken = false;
  private readonly relay: KeyRelay;
  private readonly keyboard: Keyboard;
  private readonly ended = new AbortController();
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
      if (said.kind === 'flier' && (said.there || said.page === this.flier)) {
        this.flier = said.there ? said.page : null;
      }
      if (said.kind !== 'shown') return;
      this.hearing = true;
      if (said.plane !== this.pictures.showsPlane) this.pictures.togglePlane();
      said.monitors.forEach((names, i) => {
        this.pictures.show(i, names);
      });
      this.hearing = false;
    });
    this.pictures = new Pictures(welcome, drawing, { changed: () => this.tell() });
    this.relay = new KeyRelay(
      () => this.flier !== null,
      (said) => {
        if (said.kind === 'key' && !this.taken) this.take();
        if (said.kind === 'released') this.taken = false;
        this.windows.say(said);
      },
    );
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
    window.addEventListener('pointerdown', () => this.take(), { signal: this.ended.signal });
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
    this.ended.abort();
    this.relay.dispose();
    this.keyboard.dispose();
    this.windows.dispose();
    this.pictures.dispose();
  }

  private tick(): void {
    this.request = requestAnimationFrame(() => this.tick());
    const { frame } = this;
    if (!frame || this.pictures.drawing) return;
    const { nearest } = frame.work;
    const { caution } = this.welcome.work;
    this.hearing = true; // what it shows at first is the other page's choice
    this.pictures.draw(frame, nearest && nearest.clearance < caution ? 'caution' : 'info', () => {
      this.drawn += 1;
      this.shown = this.told;
    });
    this.hearing = false;
    const now = performance.now();
    if (now - this.valuesAt < VALUES_MS) return;
    this.valuesAt = now;
    const age = (now - this.arrived) / 1000;
    this.pictures.setTime({ frame, units: unitsOf(this.welcome.units) }, age);
    setText(this.met, missionTime(frame.time_s));
    setText(this.state, age > STALE_S ? 'Lost' : this.flier ? 'Keys fly here too' : 'Watching');
    setClass(this.state, 'lost', age > STALE_S);
    this.told = { frame, restarts: this.restarts };
    if (!this.pictures.drawing) this.shown = this.told;
  }

  /** From now on camera keys act on this window's monitor. */
  private take(): void {
    this.taken = true;
    if (this.what !== 'matrix') this.windows.say({ kind: 'take', monitor: this.what });
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

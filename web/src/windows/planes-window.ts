/** A secondary window that shows what decides the order of the bodies in a monitor's picture, as a sheet. */

import { Displayed } from '../link/age';
import { Frames } from '../link/frames';
import type { Frame, Welcome } from '../link/protocol';
import { button, el, setPressed, setText } from '../panel/parts/dom';
import { FLOWN, Tether } from './secondary-window';

/** Time from the arrival of a sheet to the request for the next one [ms]. */
const PAUSE_MS = 1000;
/** Time between two updates of the rail [ms]. */
const VALUES_MS = 100;
const NO_ANSWER = 'The station does not answer.';

export class PlanesWindow {
  drawn = 0;
  readonly bodies = [];
  readonly sharpness = null;
  shown: { readonly frame: Frame | null; readonly restarts: number } = { frame: null, restarts: 0 };
  private readonly frames: Frames;
  private readonly displayed: Displayed;
  private readonly tether: Tether;
  private readonly names: readonly string[];
  private readonly keys: readonly HTMLButtonElement[];
  private readonly hold = button({ title: 'Keep this sheet' }, ['Hold'], () => this.toggleHold());
  private readonly save = button({ title: 'Save this sheet as an SVG file' }, ['Save'], () => this.store());
  private readonly text = el('p', { class: 'no-sheet', role: 'status' }, 'Waiting for the first sheet.');
  private readonly sheet = el('div', {
    class: 'sheet',
    tabindex: '0',
    role: 'region',
    'aria-label': 'Sheet',
  });
  private readonly timer: number;
  private camera: string;
  private svg = '';
  /** Camera of the sheet. */
  private drawnCamera = '';
  private held = false;
  /** Request in progress, or pause before the next one. */
  private request = new AbortController();
  private pause = 0;

  /** `monitor`: the monitor of the page whose camera the window shows. */
  constructor(
    root: HTMLElement,
    welcome: Welcome,
    private readonly monitor: 0 | 1,
  ) {
    this.frames = new Frames(welcome.control_period_s);
    this.displayed = new Displayed(this.frames, 'camera');
    this.names = welcome.cameras.filter(({ kind }) => kind !== 'engineering').map(({ name }) => name);
    this.camera = this.names[0] ?? '';
    this.keys = this.names.map((name) => button({}, [name], () => this.choose(name)));
    this.tether = new Tether(
      { ...FLOWN, name: `Planes, MON ${monitor + 1}`, title: welcome.title },
      {
        heard: (message) => {
          if (message.kind === 'page') this.follow(message.monitors[monitor]?.[0]);
        },
        take: () => this.tether.say({ kind: 'take', monitor }),
      },
    );
    root.classList.add('torn-off');
    root.replaceChildren(
      this.tether.rail,
      el(
        'main',
        { class: 'planes-sheet', 'aria-label': 'Order of the bodies' },
        el(
          'div',
          { class: 'selector' },
          el('div', { class: 'cameras', role: 'group', 'aria-label': 'Camera' }, ...this.keys),
          el('div', { class: 'monitor-keys' }, this.hold, this.save),
        ),
        this.text,
        this.sheet,
      ),
    );
    this.timer = window.setInterval(() => this.showTime(), VALUES_MS);
    this.mark();
    void this.ask();
  }

  setFrame(frame: Frame): void {
    this.frames.put(frame, performance.now());
    this.shown = this.frames.at('camera') ?? this.shown;
  }

  dispose(): void {
    clearInterval(this.timer);
    clearTimeout(this.pause);
    this.request.abort();
    this.tether.dispose();
  }

  private showTime(): void {
    const now = performance.now();
    if (this.shown.frame) this.tether.showAt(this.shown.frame, this.displayed.age(now));
    this.displayed.displayed(now);
  }

  /** Puts a camera on the page's monitor, and shows its sheet. */
  private choose(name: string): void {
    this.tether.say({ kind: 'show', monitor: this.monitor, names: [name] });
    this.follow(name);
  }

  /** Shows the sheet of the camera on the page's monitor, except that of an engineering view. */
  private follow(name: string | undefined): void {
    if (name === undefined || name === this.camera || !this.names.includes(name)) return;
    this.camera = name;
    this.mark();
    if (!this.held) void this.ask();
  }

  private mark(): void {
    this.keys.forEach((key, i) => {
      setPressed(key, this.names[i] === this.camera);
    });
    setPressed(this.hold, this.held);
    this.save.disabled = this.svg === '';
  }

  private toggleHold(): void {
    this.held = !this.held;
    this.mark();
    if (this.held) {
      this.request.abort();
      clearTimeout(this.pause);
    } else void this.ask();
  }

  /** Requests a sheet and shows it, again and again; ends an earlier call. */
  private async ask(): Promise<void> {
    this.request.abort();
    clearTimeout(this.pause);
    const request = new AbortController();
    const { camera } = this;
    this.request = request;
    if (!document.hidden) {
      try {
        const answer = await fetch(`planes/${encodeURIComponent(camera)}.svg`, {
          signal: request.signal,
        });
        const text = await answer.text();
        const made = answer.status === 200;
        this.drawnCamera = camera;
        this.show(made ? text : '', made ? '' : text.trim());
      } catch {
        if (!request.signal.aborted) this.show('', NO_ANSWER);
      }
    }
    if (request.signal.aborted) return;
    this.pause = window.setTimeout(() => void this.ask(), PAUSE_MS);
  }

  /** Shows a sheet, or else a text and no sheet. */
  private show(svg: string, text: string): void {
    this.svg = svg;
    setText(this.text, text);
    this.text.hidden = text === '';
    this.sheet.replaceChildren();
    if (svg) {
      const { documentElement } = new DOMParser().parseFromString(svg, 'image/svg+xml');
      this.sheet.append(document.importNode(documentElement, true));
      this.drawn += 1;
    }
    this.mark();
  }

  private store(): void {
    const address = URL.createObjectURL(new Blob([this.svg], { type: 'image/svg+xml' }));
    el('a', { href: address, download: `planes-${this.drawnCamera}.svg` }).click();
    URL.revokeObjectURL(address);
  }
}

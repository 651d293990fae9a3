/** One monitor: one picture, or two beside each other, and the selector of its cameras. */

import type { Subject } from '../../cameras/best-pair';
import { nameOf } from '../../input/layout';
import type { Camera } from '../../link/protocol';
import { button, el, setAttribute, setClass, setPressed, setText } from '../parts/dom';
import { Picture } from './picture';

export interface MonitorListener {
  /** Called when the user selects a half of this monitor, or presses a key of its selector. */
  taken(half: number): void;
  choose(camera: Camera): void;
  split(): void;
  slow(): void;
  /** Switches this monitor to the look of 1972, or back. Undefined if nothing computes this look. */
  seventies?: () => void;
  /** Shows in a secondary window what decides the order in the look of 1972. Undefined if no window can be opened. */
  planes?: () => void;
  /** Called when the user requests the next centre of the engineering views. */
  round(): void;
  /** Opens the monitor in a secondary window. Undefined if this monitor is already in one. */
  tearOff?: () => void;
  orbited(camera: Camera, right: number, upwards: number, nearer: number, aside: boolean): void;
  /** Whether this page can turn cameras. */
  readonly turns: boolean;
}

const ROUND = 'Change the centre of the free view: start, tip, payload or minimum clearance';
const SHIFT = 'Shift the free view by drags and arrows (as with Shift or the second button)';
const SEVENTIES = 'Draw this monitor as in 1972: polygons in few greys, with raster lines';
const PLANES =
  'Show the separating planes, trees and lists that put the bodies in order, in a secondary window';
const SLOW = 'Turn cameras at their low speed';

export class Monitor {
  readonly element: HTMLElement;
  /** Left and right picture; the right one is visible if the monitor is split. */
  readonly halves: readonly [Picture, Picture];
  private readonly keys: readonly HTMLButtonElement[];
  private readonly hand: HTMLButtonElement;
  private readonly splitKey: HTMLButtonElement;
  private readonly slowKey: HTMLButtonElement;
  private readonly seventiesKey: HTMLButtonElement;
  private readonly planesKey: HTMLButtonElement | null;
  private readonly roundKey = button({ class: 'round', title: ROUND, 'data-calm': 'full' }, [], () =>
    this.listener.round(),
  );
  private readonly bezel: HTMLElement;
  private half = 0;
  private two = false;
  private flat = false;

  constructor(
    readonly label: string,
    private readonly cameras: readonly Camera[],
    first: Camera,
    private readonly listener: MonitorListener,
  ) {
    const picture = (half: number): Picture =>
      new Picture(first, {
        taken: () => listener.taken(half),
        turns: listener.turns,
        orbited: (...by) => {
          const { camera } = half === 0 ? this.halves[0] : this.halves[1];
          listener.orbited(camera, ...by);
        },
      });
    this.halves = [picture(0), picture(1)];
    this.keys = cameras.map((camera) =>
      button({ title: camera.title, 'data-calm': `camera ${camera.name}` }, [camera.name], () => {
        listener.taken(this.half);
        listener.choose(camera);
      }),
    );
    this.hand = button({ class: 'hand' }, [label, ' ', el('em', {}, 'selected')], () =>
      listener.taken(this.half),
    );
    this.splitKey = button(
      { title: `Show two cameras beside each other: ${nameOf('KeyZ')}`, 'data-calm': 'split' },
      ['Split'],
      () => {
        listener.taken(this.half);
        listener.split();
      },
    );
    this.slowKey = button({ class: 'slow', 'data-calm': 'slow camera' }, [], () => listener.slow());
    const { seventies, planes, tearOff } = listener;
    this.seventiesKey = button({ class: 'seventies', title: SEVENTIES, 'data-calm': 'full' }, ['1972'], () =>
      seventies?.(),
    );
    this.planesKey = planes ? button({ class: 'planes', title: PLANES }, ['Planes'], planes) : null;
    const off = tearOff
      ? [
          button(
            {
              class: 'off',
              title: `Open ${label} in a secondary window`,
              'aria-label': 'Own window',
              'data-calm': 'full',
            },
            ['↗'],
            tearOff,
          ),
        ]
      : [];
    this.bezel = el('div', { class: 'bezel' }, this.halves[0].element, this.roundKey);
    if (this.planesKey) this.bezel.append(this.planesKey);
    this.element = el(
      'section',
      { class: 'monitor', 'aria-label': label },
      this.bezel,
      el(
        'div',
        { class: 'selector' },
        this.hand,
        el('div', { class: 'cameras', role: 'group', 'aria-label': `Camera of ${label}` }, ...this.keys),
        el(
          'div',
          { class: 'monitor-keys' },
          this.slowKey,
          this.splitKey,
          ...(seventies ? [this.seventiesKey] : []),
          ...off,
        ),
      ),
    );
    this.setRound(null);
    this.setSplit(false);
  }

  /** The selected picture, on which the camera keys act. */
  get picture(): Picture {
    return this.half === 1 && this.two ? this.halves[1] : this.halves[0];
  }

  /** The visible pictures, from the left. */
  get pictures(): readonly Picture[] {
    return this.two ? this.halves : [this.halves[0]];
  }

  get split(): boolean {
    return this.two;
  }

  /** Shows one camera, or two in halves. Names without a camera are ignored. */
  show(names: readonly string[]): void {
    const cameras = names.flatMap((name) => this.cameras.filter((camera) => camera.name === name));
    if (cameras.length === 0) return;
    cameras.slice(0, 2).forEach((camera, half) => {
      this.halves[half]?.show(camera);
    });
    this.setSplit(cameras.length > 1);
  }

  choose(camera: Camera): void {
    this.picture.show(camera);
    this.mark();
  }

  /** Shows the camera that is `by` positions after the present one. */
  step(by: number): void {
    const { cameras } = this;
    const at = cameras.indexOf(this.picture.camera);
    const next = cameras[(at + by + cameras.length) % cameras.length];
    if (next) this.choose(next);
  }

  /** Splits the monitor and selects its right half, or shows only the selected half. */
  toggleSplit(): void {
    if (this.two) {
      this.halves[0].show(this.picture.camera);
      this.setSplit(false);
    } else {
      this.half = 1;
      this.setSplit(true);
    }
  }

  /** Marks the selected half; null if this monitor is not selected. */
  setInHand(half: number | null): void {
    if (half !== null) this.half = half;
    setClass(this.element, 'in-hand', half !== null);
    setAttribute(this.hand, 'aria-pressed', String(half !== null));
    this.mark();
  }

  setSlow(on: boolean): void {
    setPressed(this.slowKey, on);
  }

  /** Shows whether this monitor has the look of 1972. */
  setSeventies(on: boolean): void {
    this.flat = on;
    setPressed(this.seventiesKey, on);
    this.markPlanes();
  }

  /** The sheet of planes shows a camera from where the scenario has it, and an engineering view is elsewhere. */
  private markPlanes(): void {
    if (this.planesKey) this.planesKey.hidden = !this.flat || this.picture.camera.kind === 'engineering';
  }

  /** Shows the name of the centre of the engineering views; null for their initial centre. */
  setRound(subject: Subject | null): void {
    setText(this.roundKey, `Centre: ${subject ?? 'start'}`);
  }

  private setSplit(on: boolean): void {
    this.two = on;
    if (!on) this.half = 0;
    if (on) this.bezel.append(this.halves[1].element);
    else this.halves[1].element.remove();
    setClass(this.bezel, 'split', on);
    setPressed(this.splitKey, on);
    this.mark();
  }

  private mark(): void {
    this.halves.forEach(({ element }, i) => {
      setClass(element, 'half-in-hand', this.two && i === this.half);
    });
    const { camera } = this.picture;
    const free = camera.kind === 'engineering';
    this.roundKey.hidden = !free;
    this.markPlanes();
    setText(this.slowKey, free ? 'Shift' : 'Slow');
    setAttribute(this.slowKey, 'title', `${free ? SHIFT : SLOW}: ${nameOf('Semicolon')}`);
    this.keys.forEach((key, i) => {
      setPressed(key, this.cameras[i] === camera);
    });
  }
}

/** One monitor: its picture, or two beside each other, and its selector. */

import type { Target } from '../../cameras/best-pair';
import { nameOf } from '../../input/layout';
import type { Camera } from '../../link/protocol';
import { button, el, setAttribute, setClass, setPressed, setText } from '../parts/dom';
import { Picture } from './picture';

export interface MonitorListener {
  /** The operator took a half of this monitor in hand, or pressed a key of the selector, which acts on it. */
  taken(half: number): void;
  choose(camera: Camera): void;
  split(): void;
  slow(): void;
  /** Engineering views shall go round something else. */
  round(): void;
  /** It shall be shown in a window of its own; absent: it is. */
  tearOff?: () => void;
  orbited(camera: Camera, right: number, upwards: number, nearer: number, aside: boolean): void;
  /** Cameras can be turned from this page. */
  readonly turns: boolean;
}

const ROUND = 'What the free view goes round: where it began, the tip, the payload or the narrowest gap';
const SHIFT = 'Drags and arrows shift the free view (as a drag with Shift or the second button does)';
const SLOW = 'Cameras turn at their low speed';

export class Monitor {
  readonly element: HTMLElement;
  /** Left and right; the right one is shown where the monitor is split. */
  readonly halves: readonly [Picture, Picture];
  private readonly keys: readonly HTMLButtonElement[];
  private readonly hand: HTMLButtonElement;
  private readonly splitKey: HTMLButtonElement;
  private readonly slowKey: HTMLButtonElement;
  private readonly roundKey = button({ class: 'round', title: ROUND }, [], () => this.listener.round());
  private readonly bezel: HTMLElement;
  private half = 0;
  private two = false;

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
      button({ title: camera.title }, [camera.name], () => {
        listener.taken(this.half);
        listener.choose(camera);
      }),
    );
    this.hand = button({ class: 'hand' }, [label, el('em', {}, 'in hand')], () => listener.taken(this.half));
    this.splitKey = button(
      { title: `Show two cameras beside each other: ${nameOf('KeyZ')}` },
      ['Split'],
      () => {
        listener.taken(this.half);
        listener.split();
      },
    );
    this.slowKey = button({ class: 'slow' }, [], () => listener.slow());
    const { tearOff } = listener;
    const off = tearOff
      ? [
          button(
            { class: 'off', title: `${label} in a secondary window`, 'aria-label': 'Own window' },
            ['↗'],
            tearOff,
          ),
        ]
      : [];
    this.bezel = el('div', { class: 'bezel' }, this.halves[0].element, this.roundKey);
    this.element = el(
      'section',
      { class: 'monitor', 'aria-label': label },
      this.bezel,
      el(
        'div',
        { class: 'selector' },
        this.hand,
        el('div', { class: 'cameras', role: 'group', 'aria-label': `Camera of ${label}` }, ...this.keys),
        el('div', { class: 'monitor-keys' }, this.slowKey, this.splitKey, ...off),
      ),
    );
    this.setRound(null);
    this.setSplit(false);
  }

  /** What the camera keys act on. */
  get picture(): Picture {
    return this.half === 1 && this.two ? this.halves[1] : this.halves[0];
  }

  /** Those that are shown, from the left. */
  get pictures(): readonly Picture[] {
    return this.two ? this.halves : [this.halves[0]];
  }

  get split(): boolean {
    return this.two;
  }

  /** Shows other cameras: one, or two halves; those that there are not leave what is shown. */
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

  /** The camera so many places on from the one in hand. */
  step(by: number): void {
    const { cameras } = this;
    const at = cameras.indexOf(this.picture.camera);
    const next = cameras[(at + by + cameras.length) % cameras.length];
    if (next) this.choose(next);
  }

  /** Splits, with the right half in hand, or leaves the half in hand alone. */
  toggleSplit(): void {
    if (this.two) {
      this.halves[0].show(this.picture.camera);
      this.setSplit(false);
    } else {
      this.half = 1;
      this.setSplit(true);
    }
  }

  /** `half`: which one of its halves is in hand; null: none is. */
  setInHand(half: number | null): void {
    if (half !== null) this.half = half;
    setClass(this.element, 'in-hand', half !== null);
    setAttribute(this.hand, 'aria-pressed', String(half !== null));
    this.mark();
  }

  setSlow(on: boolean): void {
    setPressed(this.slowKey, on);
  }

  /** What engineering views go round; null: the place where they began. */
  setRound(target: Target | null): void {
    setText(this.roundKey, `Round ${target ?? 'place'}`);
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
    setText(this.slowKey, free ? 'Shift' : 'Slow');
    setAttribute(this.slowKey, 'title', `${free ? SHIFT : SLOW}: ${nameOf('Semicolon')}`);
    this.keys.forEach((key, i) => {
      setPressed(key, this.cameras[i] === camera);
    });
  }
}

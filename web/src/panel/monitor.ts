/** One monitor: a hole over the scene's canvas, what is burned into its picture, and its selector. */

import { degrees, timeCode } from '../format';
import type { Camera, Frame, Vec3 } from '../protocol';
import { axesOverlay } from './axes';
import { button, el, setAttribute, setClass, setPressed, setText, svg } from './dom';
import { type GapLine, gapOverlay, type Touch } from './gap-overlay';
import type { Box, Size } from './label-place';

/** A picture older than this is stale [s]. */
export const STALE_S = 0.5;

export interface MonitorListener {
  /** The operator took this monitor in hand. */
  taken(): void;
}

export class Monitor {
  readonly element: HTMLElement;
  readonly picture = el('div', { class: 'picture' });
  private readonly keys: HTMLButtonElement[];
  private readonly name = el('b');
  private readonly title = el('span');
  private readonly time = el('span', { class: 'code' });
  private readonly age = el('span');
  private readonly lens = el('span');
  private readonly stale = el('p', { class: 'stale' });
  private readonly axes = axesOverlay();
  private readonly gap = gapOverlay((picture) => this.burnedIn(picture));
  private corners: { readonly of: Size; readonly boxes: readonly Box[] } | null = null;
  private readonly hand: HTMLButtonElement;
  private chosen: number;

  constructor(
    label: string,
    private readonly cameras: readonly Camera[],
    first: string,
    listener: MonitorListener,
  ) {
    this.chosen = Math.max(
      0,
      cameras.findIndex(({ name }) => name === first),
    );
    this.keys = cameras.map(({ name, title }, index) =>
      button({ title }, [name], () => {
        listener.taken();
        this.choose(index);
      }),
    );
    this.hand = button({ class: 'hand' }, [label, el('em', {}, 'in hand')], () => listener.taken());
    this.picture.append(
      el('p', { class: 'burned name' }, this.name, ' ', this.title),
      el('p', { class: 'burned time' }, this.time, this.age),
      el('p', { class: 'burned lens' }, this.lens),
      reticle(),
      this.axes.element,
      ...this.gap.elements,
      this.stale,
    );
    this.picture.addEventListener('click', () => listener.taken());
    this.element = el(
      'section',
      { class: 'monitor', 'aria-label': label },
      el('div', { class: 'bezel' }, this.picture),
      el(
        'div',
        { class: 'selector' },
        this.hand,
        el('div', { class: 'cameras', role: 'group', 'aria-label': `Camera of ${label}` }, ...this.keys),
      ),
    );
    this.choose(this.chosen);
  }

  get camera(): string {
    return this.cameras[this.chosen]?.name ?? '';
  }

  /** Puts the camera of that number on, if there is one. */
  choose(index: number): void {
    const camera = this.cameras[index];
    if (!camera) return;
    this.chosen = index;
    setText(this.name, camera.name);
    setText(this.title, camera.title);
    setText(this.lens, `FIXED  FOV ${degrees(camera.field_of_view, 1, false)}°`);
    this.keys.forEach((key, i) => {
      setPressed(key, i === index);
    });
  }

  step(by: number): void {
    this.choose((this.chosen + by + this.cameras.length) % this.cameras.length);
  }

  setInHand(on: boolean): void {
    setClass(this.element, 'in-hand', on);
    setAttribute(this.hand, 'aria-pressed', String(on));
  }

  /** The control frame's axes, at picture rate. */
  setAxes(directions: readonly [Vec3, Vec3, Vec3]): void {
    this.axes.set(directions);
  }

  /** The narrowest gap and what touches, as this picture of that size sees them, at picture rate. */
  setGap(line: GapLine | null, touches: readonly Touch[], picture: Size): void {
    this.gap.show(line, touches, picture);
  }

  private burnedIn(picture: Size): readonly Box[] {
    const { corners } = this;
    if (corners?.of.width === picture.width && corners.of.height === picture.height) return corners.boxes;
    this.corners = { of: picture, boxes: cornersOf(picture) };
    return this.corners.boxes;
  }

  /** How wide the gap is. */
  setGapText(text: string): void {
    this.gap.setText(text);
  }

  /** Time code of the picture and its age [s]; null: it is a recorded one. */
  setTime(frame: Frame, age: number | null): void {
    const stale = age !== null && age > STALE_S;
    setText(this.time, timeCode(frame.time_s));
    setText(this.age, age === null ? 'recorded' : stale ? `${age.toFixed(1)} s old` : 'live');
    setText(this.stale, stale ? `${age.toFixed(1)} s old` : '');
    setClass(this.picture, 'is-stale', stale);
  }
}

/** What is burned into the corners of a picture, with room around it [px]. */
function cornersOf({ width, height }: Size): readonly Box[] {
  const rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
  const [across, axes, lens] = [0.4 * width, 7 * rem, 2 * rem];
  return [
    { left: 0, top: 0, right: width, bottom: 2.6 * rem },
    { left: 0, top: height - axes, right: axes, bottom: height },
    { left: width - across, top: height - lens, right: width, bottom: height },
  ];
}

function reticle(): SVGSVGElement {
  return svg(
    'svg',
    { class: 'reticle', viewBox: '-30 -30 60 60', 'aria-hidden': 'true' },
    svg('path', { class: 'edge', d: 'M-30 0 H-12 M12 0 H30 M0 -30 V-12 M0 12 V30' }),
    svg('path', { d: 'M-30 0 H-12 M12 0 H30 M0 -30 V-12 M0 12 V30' }),
  );
}

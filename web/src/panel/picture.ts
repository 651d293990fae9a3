/** One picture: a hole over the scene's canvas, and what is burned into it. */

import { timeCode } from '../format';
import type { Camera, Frame, Vec3 } from '../protocol';
import { axesOverlay } from './axes';
import { el, setAttribute, setClass, setText, svg } from './dom';
import { type GapLine, gapOverlay, type Touch } from './gap-overlay';
import type { Box, Size } from './label-place';
import { lensWords } from './lens';

/** A picture older than this is stale [s]. */
export const STALE_S = 0.5;
/** Dragging across a whole picture goes round by this much [rad]; a turn of the wheel comes nearer by this much. */
const DRAGGED = Math.PI;
const WHEEL = 1.15;

export interface PictureListener {
  /** The operator took this picture in hand. */
  taken(): void;
  /** The engineering view was dragged to the right and upwards [rad], or brought nearer by a factor. */
  orbited(right: number, upwards: number, nearer: number): void;
}

export class Picture {
  readonly element = el('div', { class: 'picture' });
  private readonly name = el('b');
  private readonly title = el('span');
  private readonly time = el('span', { class: 'code' });
  private readonly age = el('span');
  private readonly lens = el('span');
  private readonly stale = el('p', { class: 'stale' });
  private readonly pane = el('div', { class: 'pane', 'aria-hidden': 'true' });
  private readonly axes = axesOverlay();
  private readonly gap = gapOverlay((picture) => this.burnedIn(picture));
  private corners: { readonly of: Size; readonly boxes: readonly Box[] } | null = null;
  private shown: Camera;

  constructor(
    first: Camera,
    private readonly listener: PictureListener,
  ) {
    this.shown = first;
    this.element.append(
      this.pane,
      el('p', { class: 'burned name' }, this.name, ' ', this.title),
      el('p', { class: 'burned time' }, this.time, this.age),
      el('p', { class: 'burned lens' }, this.lens),
      reticle(),
      this.axes.element,
      ...this.gap.elements,
      this.stale,
    );
    this.element.addEventListener('click', () => listener.taken());
    this.followMouse();
    this.show(first);
  }

  get camera(): Camera {
    return this.shown;
  }

  show(camera: Camera): void {
    this.shown = camera;
    setText(this.name, camera.name);
    setText(this.title, camera.title);
    setClass(this.element, 'free', camera.kind === 'engineering');
    setClass(this.element, 'window', camera.kind === 'window');
  }

  /** What the camera's drives stand at: pan, tilt, field of view [rad]; null: it has none. At picture rate. */
  setLens(setting: Vec3 | null, { width }: Size): void {
    setText(this.lens, lensWords(this.shown, setting));
    fitPane(this.pane, this.shown, width);
  }

  /** The control frame's axes, at picture rate. */
  setAxes(directions: readonly [Vec3, Vec3, Vec3]): void {
    this.axes.set(directions);
  }

  /** The narrowest gap and what touches, as this picture of that size sees them, at picture rate. */
  setGap(line: GapLine | null, touches: readonly Touch[], picture: Size): void {
    this.gap.show(line, touches, picture);
  }

  /** How wide the gap is. */
  setGapText(text: string): void {
    this.gap.setText(text);
  }

  /** Time code of the picture and its age [s]; null: it is a recorded one. */
  setTime(frame: Frame, age: number | null): void {
    const stale = age !== null && age > STALE_S;
    setText(this.time, timeCode(frame.time_s));
    const how = age === null ? 'recorded' : stale ? `${age.toFixed(1)} s old` : 'live';
    const locked = frame.lighting.locked.some(({ camera }) => camera === this.shown.name);
    setText(this.age, locked ? `EXP LOCK  ${how}` : how);
    setText(this.stale, stale ? `${age.toFixed(1)} s old` : '');
    setClass(this.element, 'is-stale', stale);
  }

  private burnedIn(picture: Size): readonly Box[] {
    const { corners } = this;
    if (corners?.of.width === picture.width && corners.of.height === picture.height) return corners.boxes;
    this.corners = { of: picture, boxes: cornersOf(picture) };
    return this.corners.boxes;
  }

  private followMouse(): void {
    const { element } = this;
    element.addEventListener('pointerdown', (event) => {
      if (this.shown.kind === 'engineering') element.setPointerCapture(event.pointerId);
    });
    element.addEventListener('pointermove', (event) => {
      if (!element.hasPointerCapture(event.pointerId)) return;
      const per = DRAGGED / element.clientWidth;
      this.listener.orbited(-event.movementX * per, event.movementY * per, 1);
    });
    element.addEventListener(
      'wheel',
      (event) => {
        if (this.shown.kind !== 'engineering') return;
        event.preventDefault();
        this.listener.orbited(0, 0, event.deltaY < 0 ? WHEEL : 1 / WHEEL);
      },
      { passive: false },
    );
  }
}

/** Opens a window's pane in a picture so many pixels wide. */
export function fitPane(element: HTMLElement, { pane, field_of_view }: Camera, width: number): void {
  if (!pane) return;
  const perMetre = width / (2 * Math.tan(field_of_view / 2) * pane.distance);
  const [wide, high] = [pane.width, pane.height].map((size) => `${(size * perMetre).toFixed(1)}px`);
  setAttribute(element, 'style', `width: ${wide}; height: ${high}`);
}

/** What is burned into the corners of a picture, with room around it [px]. */
function cornersOf({ width, height }: Size): readonly Box[] {
  const rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
  const [across, axes, lens] = [0.5 * width, 7 * rem, 3 * rem];
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

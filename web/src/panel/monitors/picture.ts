/** One picture: a transparent element over the scene's canvas, with texts and marks over it. */

import { CameraDrag, type Place } from '../../input/camera-drag';
import type { Turning } from '../../input/camera-hand';
import { onPress } from '../../input/press';
import { type Age, isStale } from '../../link/age';
import type { Camera, Frame, Vec3 } from '../../link/protocol';
import { inset } from '../../page/room';
import { EXAGGERATION } from '../../scene/bending';
import type { Part } from '../../scene/drawn';
import { fieldOf } from '../../scene/free-part';
import { timeCode } from '../../words/format';
import { lensWords } from '../../words/lens';
import { el, setAttribute, setClass, setStyle, setText, svg } from '../parts/dom';
import { axesOverlay } from './axes';
import { type GapLine, gapOverlay, type Touch } from './gap-overlay';
import type { Box, Size } from './label-place';
import { PolygonPane } from './polygon-pane';
import { type PushArrow, pushOverlay } from './push-overlay';

/** Rotation of an engineering view by a drag across the whole picture [rad]. */
const DRAGGED = Math.PI;
/** Factor by which a step of the wheel changes the distance of an engineering view. */
const WHEEL = 1.15;
/** Bit of a mouse's second button in `buttons`. */
const SECOND = 2;
/** Hints about the effects of mouse and fingers in a picture. */
const HINTS = {
  turns: 'drag: pan, tilt · wheel or pinch: zoom',
  zooms: 'wheel or pinch: zoom',
  none: '',
} as const;
const WATCHED = 'observing: only the operator moves cameras';

export interface PictureListener {
  /** Called when the user selects this picture. */
  taken(): void;
  /** Called to rotate the engineering view [rad], or to shift it if `aside`, and to divide its distance by `nearer`. */
  orbited(right: number, upwards: number, nearer: number, aside: boolean): void;
  /** Whether this page can turn cameras. */
  readonly turns: boolean;
}

/** CSS selector of the touch sticks, which are over the lower corners of the pictures. */
const TOUCH = 'div.touch';

export class Picture {
  readonly element = el('div', { class: 'picture' });
  /** The picture in the look of 1972, hidden while the scene draws this picture. */
  readonly polygons = new PolygonPane();
  private readonly drag = new CameraDrag();
  private readonly band = svg('path', { class: 'band' });
  private readonly hint = el('span');
  private readonly name = el('b');
  private readonly title = el('span');
  private readonly time = el('span', { class: 'code', 'data-calm': 'full' });
  private readonly age = el('span');
  private readonly lens = el('span');
  private readonly oldness = el('b');
  private readonly cure = el('span');
  private readonly stale = el('p', { class: 'stale' }, this.oldness, this.cure);
  private readonly preparing = el('p', { class: 'preparing', role: 'status', hidden: '' });
  private readonly pane = el('div', { class: 'pane', 'aria-hidden': 'true' });
  private readonly axes = axesOverlay();
  private readonly pushes = pushOverlay();
  private readonly gap = gapOverlay((picture) => this.burnedIn(picture));
  private corners: { readonly of: string; readonly boxes: readonly Box[] } | null = null;
  private shown: Camera;
  /** Words before the age. */
  private marks: readonly string[] = [];

  constructor(
    first: Camera,
    private readonly listener: PictureListener,
  ) {
    this.shown = first;
    this.element.append(
      ...this.polygons.elements,
      this.pane,
      el('p', { class: 'burned name' }, this.name, ' ', this.title),
      el('p', { class: 'burned time' }, this.time, this.age),
      el('p', { class: 'burned lens', 'data-calm': 'lens' }, this.lens),
      reticle(),
      this.axes.element,
      svg('svg', { class: 'dragged', 'aria-hidden': 'true' }, this.band),
      el(
        'p',
        { class: 'burned hint', 'aria-hidden': 'true' },
        this.hint,
        el('span', { class: 'barred' }, WATCHED),
      ),
      this.pushes.element,
      ...this.gap.elements,
      this.stale,
      this.preparing,
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
    setClass(this.element, 'driven', this.drivable);
    setText(this.hint, HINTS[drives(camera)]);
    setClass(this.element, 'window', camera.kind === 'window');
  }

  /** Writes the settings of the camera's drives, at picture rate: pan, tilt, field of view [rad]. */
  setLens(setting: Vec3, size: Size, free: Part): void {
    setText(this.lens, lensWords(this.shown, setting));
    fitPane(this.pane, this.shown, { width: size.width * free.width, height: size.height * free.height });
    const [x, y] = [free.left + free.width / 2, free.top + free.height / 2];
    setStyle(this.element, `--middle-x: ${(100 * x).toFixed(2)}%; --middle-y: ${(100 * y).toFixed(2)}%`);
  }

  /** Deflections of this camera's switches, commanded by a drag, a pinch or the mouse wheel. */
  turning(now: number): Turning {
    return this.drag.turning(now);
  }

  /** Draws the control frame's axes, at picture rate; `marked`: whether a large angle to the picture is marked. */
  setAxes(directions: readonly [Vec3, Vec3, Vec3], marked: boolean): void {
    this.axes.set(directions, marked);
  }

  /** Draws the minimum clearance and the contacts at picture rate; `picture`: size of the picture. */
  setGap(line: GapLine | null, touches: readonly Touch[], picture: Size): void {
    this.gap.show(line, touches, picture);
  }

  /** Draws the forces of contacts and disturbances, at picture rate. */
  setPushes(arrows: readonly PushArrow[]): void {
    this.pushes.show(arrows);
  }

  /** Writes the minimum clearance; `seen`: whether each end of the line is visible in this picture. */
  setGapText(text: string, seen: readonly [boolean, boolean]): void {
    this.gap.setText(text, seen);
  }

  /** Writes the picture's time code; `exaggerated`: whether bending is exaggerated. */
  setTime(frame: Frame, exaggerated: boolean): void {
    setText(this.time, timeCode(frame.time_s));
    const locked = frame.display.lighting.locked.some(({ camera }) => camera === this.shown.name);
    this.marks = [...(exaggerated ? [`BEND × ${EXAGGERATION}`] : []), ...(locked ? ['EXP LOCK'] : [])];
  }

  /** Writes the picture's age; `fresh`: its text if it is not old; `cure`: what to do if it is. */
  setAge(age: Age, fresh: string, cure: string): void {
    const stale = isStale(age);
    const old = `${age.s.toFixed(1)} s old`;
    setText(this.age, [...this.marks, stale || age.set > 0 ? old : fresh].join('  '));
    setText(this.oldness, stale ? old : '');
    setText(this.cure, stale ? cure : '');
    setClass(this.element, 'is-stale', stale);
  }

  /** Writes the progress of the full drawing profile; empty when it is shown. */
  setPreparing(text: string): void {
    setText(this.preparing, text);
    this.preparing.hidden = text === '';
  }

  private burnedIn(picture: Size): readonly Box[] {
    const { corners } = this;
    const touched = document.querySelector<HTMLElement>(TOUCH)?.hidden === false;
    const flat = !this.polygons.hidden;
    const of = `${picture.width} ${picture.height} ${touched} ${flat}`;
    if (corners?.of === of) return corners.boxes;
    const own =
      inset() && !this.element.closest('.torn-off')
        ? this.narrowCorners(picture, flat)
        : cornersOf(picture, flat);
    const boxes = touched ? [...own, ...this.touchSticks()] : own;
    this.corners = { of, boxes };
    return boxes;
  }

  /**
   * Boxes of this picture's texts if the page shows MON 2 in a corner of MON 1. For a picture of MON 1, MON 2 is one
   * more box.
   */
  private narrowCorners(picture: Size, flat: boolean): readonly Box[] {
    const own = cornersOf(picture, flat);
    if (this.element.closest('.monitor + .monitor')) return own;
    const { width, height } = picture;
    return [...own, { left: 0.5 * width, top: 0, right: width, bottom: 0.5 * height }];
  }

  /** Boxes of the touch sticks, measured from the top left of this picture. */
  private touchSticks(): readonly Box[] {
    const { left: x, top: y } = this.element.getBoundingClientRect();
    return [...document.querySelectorAll(`${TOUCH} > div`)].map((part) => {
      const { left, top, right, bottom } = part.getBoundingClientRect();
      return { left: left - x, top: top - y, right: right - x, bottom: bottom - y };
    });
  }

  private followMouse(): void {
    const { element, drag } = this;
    onPress(element, (event) => {
      const free = this.shown.kind === 'engineering';
      if (!free && !this.drivable) return null;
      const { pointerId } = event;
      element.setPointerCapture(pointerId);
      if (free) return { moved: (at) => this.turnBy(at), ended() {} };
      this.listener.taken();
      drag.press(pointerId, this.placeOf(event), element.clientHeight);
      return {
        moved: (at) => {
          drag.move(pointerId, this.placeOf(at));
          this.drawBand();
        },
        ended: () => {
          drag.lift(pointerId);
          this.drawBand();
        },
      };
    });
    element.addEventListener('contextmenu', (event) => {
      if (this.shown.kind === 'engineering') event.preventDefault();
    });
    element.addEventListener(
      'wheel',
      (event) => {
        const free = this.shown.kind === 'engineering';
        if ((!free && !this.drivable) || event.deltaY === 0) return;
        event.preventDefault();
        const nearer = event.deltaY < 0;
        if (free) this.listener.orbited(0, 0, nearer ? WHEEL : 1 / WHEEL, false);
        else {
          this.listener.taken();
          drag.turnWheel(nearer ? 1 : -1, performance.now());
        }
      },
      { passive: false },
    );
  }

  /** Rotates the engineering view by a motion of the pointer, or shifts it. */
  private turnBy({ movementX, movementY, shiftKey, buttons }: PointerEvent): void {
    const per = DRAGGED / this.element.clientWidth;
    const aside = shiftKey || (buttons & SECOND) !== 0;
    this.listener.orbited(-movementX * per, movementY * per, 1, aside);
  }

  private get drivable(): boolean {
    return this.listener.turns && this.shown.drive !== null;
  }

  private placeOf({ clientX, clientY }: MouseEvent): Place {
    const { left, top } = this.element.getBoundingClientRect();
    return { x: clientX - left, y: clientY - top };
  }

  /** A line from the start of a drag; its length sets the camera's rate. */
  private drawBand(): void {
    const { line } = this.drag;
    const at = ({ x, y }: Place) => `${x.toFixed(1)} ${y.toFixed(1)}`;
    setAttribute(this.band, 'd', line ? `M${at(line.from)} L${at(line.to)}` : '');
  }
}

/** Returns what drags, pinches and the wheel do to a camera: they turn and zoom it, they only zoom it, or nothing. */
function drives({ drive }: Camera): keyof typeof HINTS {
  if (!drive) return 'none';
  return drive.pan || drive.tilt ? 'turns' : 'zooms';
}

/** Fits the outline of a window's pane to a picture of this width [px]. */
export function fitPane(
  element: HTMLElement,
  { pane, field_of_view }: Camera,
  { width, height }: Size,
): void {
  if (!pane) return;
  const perMetre = fieldOf({ width, height }) / (2 * Math.tan(field_of_view / 2) * pane.distance);
  const [wide, high] = [pane.width, pane.height].map((size) => `${(size * perMetre).toFixed(1)}px`);
  setStyle(element, `width: ${wide}; height: ${high}`);
}

/** Boxes of the texts in the corners of a picture, with a margin [px]; `flat`: whether it has the look of 1972. */
function cornersOf({ width, height }: Size, flat: boolean): readonly Box[] {
  const rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
  const [across, axes, lens, key] = [0.5 * width, 7 * rem, 3 * rem, 5 * rem];
  return [
    { left: 0, top: 0, right: width, bottom: 2.6 * rem },
    { left: 0, top: height - axes, right: axes, bottom: height },
    { left: width - across, top: height - lens, right: width, bottom: height },
    ...(flat ? [{ left: width - key, top: height - 5 * rem, right: width, bottom: height }] : []),
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

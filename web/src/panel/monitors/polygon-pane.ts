/** A picture in the look of 1972: polygons in few greys under raster lines, drawn on a canvas over the scene's. */

import { Silence } from '../../basics/silence';
import type { Age } from '../../link/age';
import type { Polygons } from '../../link/protocol';
import { ASPECT } from '../../scene/drawn';
import { el, setStyle, setText } from '../parts/dom';
import type { Size } from './label-place';

/** Half the width of a picture, in the units of `Polygons.points`. */
const HALF_WIDTH = 10_000;
/** Distance and darkness of the raster lines [px], as in `aftdeck render`. */
const [RASTER, DARK] = [3, 'rgb(0 0 0 / 45%)'];
/** Width of the line round each polygon, which closes the gaps between neighbours [px]. */
const SEAM = 0.7;
/** Greatest number of pixels of the canvas for each pixel of the page, in each direction. */
const SHARPEST = 2;
/** Greatest time between two readings of the age that counts [ms]: a page that stands still receives no pictures. */
const MOST_MS = 250;

/** What `drawPolygons` uses of a canvas. */
export type Pen = Pick<
  CanvasRenderingContext2D,
  | 'fillStyle'
  | 'strokeStyle'
  | 'lineWidth'
  | 'lineJoin'
  | 'beginPath'
  | 'moveTo'
  | 'lineTo'
  | 'closePath'
  | 'fill'
  | 'stroke'
  | 'fillRect'
>;

/** Draws a picture that is `width` by `height` px. Neighbours in the order that have the same grey share a path. */
export function drawPolygons(pen: Pen, picture: Polygons, { width, height }: Size): void {
  pen.fillStyle = '#000';
  pen.fillRect(0, 0, width, height);
  const [points, corners, greys] = [places(picture.points), bytes(picture.corners), bytes(picture.greys)];
  const scale = width / 2 / HALF_WIDTH;
  pen.lineWidth = SEAM;
  pen.lineJoin = 'round';
  let next = 0;
  corners.forEach((count, i) => {
    if (greys[i] !== greys[i - 1]) pen.beginPath();
    for (let k = 0; k < count; k++, next += 2) {
      const x = width / 2 + scale * (points[next] ?? 0);
      const y = height / 2 + scale * (points[next + 1] ?? 0);
      if (k === 0) pen.moveTo(x, y);
      else pen.lineTo(x, y);
    }
    pen.closePath();
    if (greys[i] === greys[i + 1]) return;
    const grey = greys[i] ?? 0;
    pen.fillStyle = pen.strokeStyle = `rgb(${grey} ${grey} ${grey})`;
    pen.fill();
    pen.stroke();
  });
  pen.fillStyle = DARK;
  for (let y = 0; y < height; y += RASTER) pen.fillRect(0, y, width, 1);
}

function bytes(base64: string): Uint8Array {
  return Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
}

/** Returns 16-bit integers (little-endian). */
function places(base64: string): Int16Array {
  const view = new DataView(bytes(base64).buffer);
  return Int16Array.from({ length: view.byteLength / 2 }, (_, i) => view.getInt16(2 * i, true));
}

export class PolygonPane {
  private readonly canvas = el('canvas', { class: 'polygons', 'aria-hidden': 'true' });
  private readonly bar = el('progress', { max: '1', hidden: '', 'aria-label': 'Preparation' });
  private readonly words = el('span');
  private readonly text = el('p', { class: 'no-picture' }, this.words, this.bar);
  readonly elements: readonly [HTMLElement, HTMLElement] = [this.canvas, this.text];
  private pen: CanvasRenderingContext2D | null = null;
  private drawn: Polygons | null = null;
  private size = '';
  /** Whether the picture is that of the newest frame shown: it is then as old as the scene's pictures. */
  private current = false;
  /** Time since a new picture was drawn. */
  private readonly silence = new Silence(MOST_MS);

  constructor() {
    this.hide();
  }

  get hidden(): boolean {
    return this.canvas.hidden === true;
  }

  hide(): void {
    this.canvas.hidden = this.text.hidden = true;
    this.drawn = null;
    this.current = false;
  }

  /**
   * Returns the age of this picture at `now` [ms], if it is older than the scene's pictures with the age `scene`. The
   * station's text that it has no pictures yet has no age, and a picture that nobody can see does not grow old.
   */
  ageOf(scene: Age, now: number): Age {
    if (document.hidden) this.silence.end(now);
    const s = scene.set + this.silence.at(now) / 1000;
    const waits = this.hidden || this.current || (this.drawn !== null && this.drawn.step < 0);
    return waits || s <= scene.s ? scene : { ...scene, s, undrawn: false };
  }

  /** Draws a picture for the frame of a step, or its text in place of polygons; null: no picture has arrived. */
  show(picture: Polygons | null, step: number, place: Size): void {
    const { canvas, text } = this;
    const { height } = place;
    const width = Math.min(place.width, ASPECT * height); // the station's pictures show no more at their sides
    this.current = picture?.step === step;
    if (this.hidden || this.current || picture !== this.drawn) this.silence.end();
    canvas.hidden = text.hidden = false;
    setText(this.words, picture?.text ?? '');
    this.bar.hidden = (picture?.share ?? null) === null;
    this.bar.value = picture?.share ?? 0;
    const ratio = Math.min(window.devicePixelRatio, SHARPEST);
    const size = `${Math.round(width * ratio)} ${Math.round(height * ratio)}`;
    if (picture !== null && picture === this.drawn && size === this.size) return;
    this.drawn = picture;
    // Drawn by the processor: this takes a few milliseconds, and hundreds without a graphics card if it were not.
    this.pen ??= canvas.getContext('2d', { alpha: false, willReadFrequently: true });
    if (!this.pen) return;
    if (size !== this.size) {
      this.size = size;
      setStyle(canvas, `width: ${width}px; height: ${height}px`);
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    }
    this.pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    drawPolygons(this.pen, picture ?? NOTHING, { width, height });
  }
}

const NOTHING: Polygons = {
  ...{ type: 'polygons', step: -1, camera: '' },
  ...{ points: '', corners: '', greys: '', text: '', share: null },
};

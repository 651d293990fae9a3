/** Means of a still picture's samples, for each part of the canvas. */

import type { Area } from './drawn';

/** Bytes of a pixel. */
const PIXEL = 4;

export class Means {
  private width = 0;
  /** Sums of the samples so far, for each byte of the canvas, from its bottom left. */
  private sums = new Uint16Array();

  /** Adapts to a canvas of this size [px]. */
  resize(width: number, height: number): void {
    this.width = width;
    this.sums = new Uint16Array(PIXEL * width * height);
  }

  /** Adds the bytes of an area, row by row from its bottom. The sample 0 begins a new picture. */
  add(bytes: Uint8Array, area: Area, sample: number): void {
    this.rows(area, (first, from, line) => {
      if (sample === 0) this.sums.set(bytes.subarray(from, from + line), first);
      else for (let i = 0; i < line; i += 1) (this.sums[first + i] as number) += bytes[from + i] as number;
    });
  }

  /** Writes the mean of `count` samples of an area, row by row from its top, as a canvas of the page has them. */
  read(to: Uint8ClampedArray, area: Area, count: number): void {
    this.rows(area, (first, from, line) => {
      const at = to.length - from - line;
      for (let i = 0; i < line; i += 1) to[at + i] = (this.sums[first + i] as number) / count;
    });
  }

  /** Calls `each` with a row's first index in the sums and in the area, and with the row's length [bytes]. */
  private rows(
    { x, y, width, height }: Area,
    each: (first: number, from: number, line: number) => void,
  ): void {
    const line = PIXEL * width;
    for (let row = 0; row < height; row += 1) each(PIXEL * ((y + row) * this.width + x), row * line, line);
  }
}

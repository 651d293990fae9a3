/** Without a graphics card, reads the pictures back when they are drawn, and puts them on the page. */

import type { WebGLRenderer } from 'three';
import { present } from '../basics/assert';
import type { Area } from './drawn';
import { Means } from './means';

/** Bytes of a pixel. */
const PIXEL = 4;
/** A still picture replaces the moving one when it has this number of samples: its edges are then smooth. */
const FEWEST = 4;

/** Pixels to transfer: drawn at `from`, shown at `to`; `sample`: index of a still picture's sample, null if it moves. */
interface Part {
  readonly from: Area;
  readonly to: Area;
  readonly sample: number | null;
  /** Index of the first byte in the buffer. */
  readonly first: number;
}

/**
 * Transfers WebGL pictures to the page if no graphics card draws them. A WebGL canvas on the page would block the page
 * until the processor has drawn it. With this class, the page handles keys and texts meanwhile. The page's canvas always
 * has the full resolution: a picture that was drawn in a lower one is enlarged.
 */
export class Relay {
  private readonly gl: WebGL2RenderingContext;
  private readonly canvas: CanvasRenderingContext2D;
  /** Small pictures before they are enlarged. */
  private readonly small: CanvasRenderingContext2D;
  private readonly means = new Means();
  private buffer: WebGLBuffer | null = null;
  private size = 0;
  private bytes = new Uint8Array();
  private parts: Part[] = [];
  private done: WebGLSync | null = null;

  /** Transfers from the renderer's canvas to the canvas `shown` on the page. */
  constructor(renderer: WebGLRenderer, shown: HTMLCanvasElement) {
    this.gl = renderer.getContext() as WebGL2RenderingContext;
    [this.canvas, this.small] = [shown, document.createElement('canvas')].map((canvas) => {
      const context = canvas.getContext('2d', { alpha: false, willReadFrequently: true });
      return present(context, 'a canvas for the pictures');
    }) as [CanvasRenderingContext2D, CanvasRenderingContext2D];
  }

  /** Sets the page's canvas to the renderer's size and to one colour. */
  wipe(colour: string): void {
    const { canvas, gl } = this;
    const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
    for (const each of [canvas.canvas, this.small.canvas]) {
      if (each.width !== width) each.width = width;
      if (each.height !== height) each.height = height;
    }
    canvas.fillStyle = colour;
    canvas.fillRect(0, 0, width, height);
    this.means.resize(width, height);
  }

  /** Adds a picture that was drawn at `from`. On the page it will have the area `to`. */
  add(from: Area, to: Area, sample: number | null = null): void {
    const last = this.parts.at(-1);
    const first = last ? last.first + bytesOf(last.from) : 0;
    this.parts.push({ from, to, sample, first });
  }

  /** Requests the pixels of all added parts. */
  send(): void {
    const { gl, parts } = this;
    const last = parts.at(-1);
    if (!last) return;
    const size = last.first + bytesOf(last.from);
    if (this.bytes.length < size) this.bytes = new Uint8Array(size);
    this.buffer ??= gl.createBuffer();
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, this.buffer);
    // The buffer is allocated again each time, because Chromium warns if a buffer is written twice.
    gl.bufferData(gl.PIXEL_PACK_BUFFER, size, gl.STREAM_READ);
    this.size = size;
    for (const { from, first } of parts)
      gl.readPixels(from.x, from.y, from.width, from.height, gl.RGBA, gl.UNSIGNED_BYTE, first);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    this.done = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
  }

  /** Puts the requested pixels on the page; returns false if they are not drawn yet. */
  transfer(): boolean {
    const { gl, done } = this;
    if (!done) return this.parts.length === 0;
    const state = gl.clientWaitSync(done, 0, 0);
    if (state === gl.TIMEOUT_EXPIRED || state === gl.WAIT_FAILED) return false;
    gl.deleteSync(done);
    this.done = null;
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, this.buffer);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, this.bytes, 0, this.size);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    for (const part of this.parts) this.show(part);
    this.parts = [];
    return true;
  }

  dispose(): void {
    if (this.done) this.gl.deleteSync(this.done);
    this.gl.deleteBuffer(this.buffer);
  }

  private show({ from, to, sample, first }: Part): void {
    const bytes = this.bytes.subarray(first, first + bytesOf(from));
    const picture = this.canvas.createImageData(from.width, from.height);
    if (sample === null) {
      reverseRows(bytes, picture.data, PIXEL * from.width);
      this.put(picture, to);
      return;
    }
    this.means.add(bytes, to, sample);
    if (sample + 1 < FEWEST) return;
    this.means.read(picture.data, to, sample + 1);
    this.put(picture, to);
  }

  /** Puts a picture on the page, enlarged if it is smaller than its area there. */
  private put(picture: ImageData, { x, y, width, height }: Area): void {
    const { small, canvas } = this;
    const top = canvas.canvas.height - y - height;
    if (picture.width === width && picture.height === height) {
      canvas.putImageData(picture, x, top);
      return;
    }
    small.putImageData(picture, 0, 0);
    canvas.drawImage(small.canvas, 0, 0, picture.width, picture.height, x, top, width, height);
  }
}

function bytesOf({ width, height }: Area): number {
  return PIXEL * width * height;
}

/** Copies rows of `line` bytes in reversed order: WebGL counts rows upwards, the page downwards. */
function reverseRows(bytes: Uint8Array, to: Uint8ClampedArray, line: number): void {
  for (let from = 0; from < bytes.length; from += line)
    to.set(bytes.subarray(from, from + line), bytes.length - from - line);
}

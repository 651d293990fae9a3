/** Without a graphics card, reads the pictures back when they are drawn, and puts them on the page. */

import type { WebGLRenderer } from 'three';
import { present } from '../basics/assert';
import type { Rect } from './drawn';

/** Bytes of a pixel. */
const PIXEL = 4;

/** A part of the canvas [px from its bottom left], and the index of its first byte in the buffer. */
interface Part {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
  readonly first: number;
}

/**
 * Transfers WebGL pictures to the page if no graphics card draws them. A WebGL canvas on the page would block the page
 * until the processor has drawn it. With this class, the page handles keys and texts meanwhile.
 */
export class Relay {
  private readonly gl: WebGL2RenderingContext;
  private readonly canvas: CanvasRenderingContext2D;
  private buffer: WebGLBuffer | null = null;
  private size = 0;
  private bytes = new Uint8Array();
  private parts: Part[] = [];
  private done: WebGLSync | null = null;

  /** Transfers from the renderer's canvas to the canvas `shown` on the page. */
  constructor(
    private readonly renderer: WebGLRenderer,
    shown: HTMLCanvasElement,
  ) {
    this.gl = renderer.getContext() as WebGL2RenderingContext;
    const canvas = shown.getContext('2d', { alpha: false, willReadFrequently: true });
    this.canvas = present(canvas, 'a canvas for the pictures');
  }

  /** Sets the page's canvas to the renderer's size and to one colour. */
  wipe(colour: string): void {
    const { canvas, gl } = this;
    const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
    if (canvas.canvas.width !== width) canvas.canvas.width = width;
    if (canvas.canvas.height !== height) canvas.canvas.height = height;
    canvas.fillStyle = colour;
    canvas.fillRect(0, 0, width, height);
  }

  /** Adds a part of the canvas that was drawn; `canvas`: height of the canvas [CSS px]. */
  add({ left, top, width, height }: Rect, canvas: number): void {
    const ratio = this.renderer.getPixelRatio();
    const [x, y, wide, high] = [left, canvas - top - height, width, height].map((side) =>
      Math.round(side * ratio),
    ) as [number, number, number, number];
    const last = this.parts.at(-1);
    const first = last ? last.first + PIXEL * last.width * last.height : 0;
    this.parts.push({ x, y, width: wide, height: high, first });
  }

  /** Requests the pixels of all added parts. */
  send(): void {
    const { gl, parts } = this;
    const last = parts.at(-1);
    if (!last) return;
    const size = last.first + PIXEL * last.width * last.height;
    if (this.bytes.length < size) this.bytes = new Uint8Array(size);
    this.buffer ??= gl.createBuffer();
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, this.buffer);
    // The buffer is allocated again each time, because Chromium warns if a buffer is written twice.
    gl.bufferData(gl.PIXEL_PACK_BUFFER, size, gl.STREAM_READ);
    this.size = size;
    for (const { x, y, width, height, first } of parts)
      gl.readPixels(x, y, width, height, gl.RGBA, gl.UNSIGNED_BYTE, first);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    this.done = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
  }

  /** Puts the requested pixels on the page; returns false if they are not drawn yet. */
  put(): boolean {
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

  /** Copies a part to the page with its rows reversed: WebGL counts rows upwards, the page downwards. */
  private show({ x, y, width, height, first }: Part): void {
    const { canvas } = this;
    const picture = canvas.createImageData(width, height);
    const line = PIXEL * width;
    for (let row = 0; row < height; row++) {
      const from = first + row * line;
      picture.data.set(this.bytes.subarray(from, from + line), (height - 1 - row) * line);
    }
    canvas.putImageData(picture, x, canvas.canvas.height - y - height);
  }
}

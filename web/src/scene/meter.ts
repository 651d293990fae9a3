import type { WebGLRenderer } from 'three';
import type { Area } from './drawn';

/** Metered middle part of a picture, as a fraction of its width and of its height. */
const MIDDLE = 0.6;
/** Number of metered rows, and number of samples in each row. */
const ROWS = 9;
const PLACES = 16;

interface Look {
  readonly camera: string;
  /** Factor by which the picture multiplies light. */
  readonly factor: number;
  readonly width: number;
  readonly done: WebGLSync;
}

export interface Seen {
  readonly camera: string;
  /** Light of the strongest colour (red, green or blue) at each sample, so that no colour is overexposed. */
  readonly lights: readonly number[];
}

/**
 * Measures the light in a few rows of a drawn picture. `ask` requests the rows; `collect`, called later, returns their
 * light when the rows are available.
 */
export class Meter {
  private readonly gl: WebGL2RenderingContext;
  private buffer: WebGLBuffer | null = null;
  private look: Look | null = null;

  /** `lightOf`: for each byte, 0 to 255, the product of light and exposure that a picture displays as this byte. */
  constructor(
    renderer: WebGLRenderer,
    private readonly lightOf: readonly number[],
  ) {
    this.gl = renderer.getContext() as WebGL2RenderingContext;
  }

  /** Whether no request is pending. */
  get free(): boolean {
    return this.look === null;
  }

  /** Requests the rows of the picture just drawn. */
  ask(camera: string, area: Area, factor: number): void {
    const { gl } = this;
    const [wide, high] = [Math.floor(MIDDLE * area.width), Math.floor(MIDDLE * area.height)];
    const x = Math.round(area.x + ((1 - MIDDLE) / 2) * area.width);
    const y = Math.round(area.y + ((1 - MIDDLE) / 2) * area.height);
    if (wide < PLACES || high < ROWS || gl.isContextLost()) return;
    this.buffer ??= gl.createBuffer();
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, this.buffer);
    gl.bufferData(gl.PIXEL_PACK_BUFFER, 4 * wide * ROWS, gl.STREAM_READ);
    for (let row = 0; row < ROWS; row++) {
      const at = y + Math.floor(((row + 0.5) * high) / ROWS);
      gl.readPixels(x, at, wide, 1, gl.RGBA, gl.UNSIGNED_BYTE, 4 * wide * row);
    }
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    const done = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!done) return;
    gl.flush();
    this.look = { camera, factor, width: wide, done };
  }

  /** Returns the requested light; null if it is not available yet, or if no request is pending. */
  collect(): Seen | null {
    const { gl, look } = this;
    if (!look) return null;
    if (gl.clientWaitSync(look.done, 0, 0) === gl.TIMEOUT_EXPIRED) return null;
    this.look = null;
    gl.deleteSync(look.done);
    const bytes = new Uint8Array(4 * look.width * ROWS);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, this.buffer);
    gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, bytes);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    return { camera: look.camera, lights: lightsIn(bytes, look, this.lightOf) };
  }

  /** Discards the pending request, because the light has changed. */
  forget(): void {
    if (this.look) this.gl.deleteSync(this.look.done);
    this.look = null;
  }

  dispose(): void {
    this.forget();
    this.gl.deleteBuffer(this.buffer);
  }
}

function lightsIn(bytes: Uint8Array, { width, factor }: Look, lightOf: readonly number[]): readonly number[] {
  const found: number[] = [];
  for (let row = 0; row < ROWS; row++) {
    for (let place = 0; place < PLACES; place++) {
      const first = 4 * (row * width + Math.floor(((place + 0.5) * width) / PLACES));
      const brightest = Math.max(...bytes.subarray(first, first + 3));
      found.push((lightOf[brightest] ?? 0) / factor);
    }
  }
  return found;
}

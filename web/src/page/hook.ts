/** `window.__aftdeck`, for tests and measurements. */

import type { Sharpness } from '../cameras/fineness';
import type { Views } from '../cameras/pictures';
import type { Frame } from '../link/protocol';
import type { DrawnBody } from '../scene/bodies';

export interface Hook {
  /** Number of pictures drawn, in total (`frames`) and in the last whole second (`fps`). */
  frames: number;
  fps: number;
  /** Last frame that pictures, lamps and numbers have all shown. */
  lastFrame: Frame | null;
  /** Number of restarts before this frame. Restarts are counted when frames arrive, so that none is missed. */
  restarts: number;
  /** Latency from a stick to its picture, 95th percentile of the last 10 s [ms]; null if no stick moved. */
  latency95: number | null;
  /** Sharpness of the pictures on the page; null in the full profile and before the first pictures. */
  sharpness: Sharpness | null;
  /** The bodies of the scene as they are drawn now. */
  readonly bodies: readonly DrawnBody[];
  /** Result of a survey of each camera at the frame drawn last, and the cameras of the two monitors. */
  readonly views: Views | null;
  /** Renderer's name in WebGL. */
  renderer: string;
}

declare global {
  interface Window {
    __aftdeck: Hook;
  }
}

/** Publishes the hook; `read` returns its present values and is called at each access. */
export function publish(
  renderer: string,
  read: () => Omit<Hook, 'fps' | 'renderer' | 'views'>,
  views: () => Views | null = () => null,
): void {
  let fps = 0;
  let before = 0;
  setInterval(() => {
    const { frames } = read();
    fps = Math.max(0, frames - before);
    before = frames;
  }, 1000);
  window.__aftdeck = {
    get frames() {
      return read().frames;
    },
    get fps() {
      return fps;
    },
    get lastFrame() {
      return read().lastFrame;
    },
    get restarts() {
      return read().restarts;
    },
    get latency95() {
      return read().latency95;
    },
    get sharpness() {
      return read().sharpness;
    },
    get bodies() {
      return read().bodies;
    },
    get views() {
      return views();
    },
    renderer,
  };
}

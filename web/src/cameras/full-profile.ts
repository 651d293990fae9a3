/** Makes the scene of the full profile while the page shows the low profile. */

import type { Frame, Welcome } from '../link/protocol';
import type { Drawing } from '../page/quality';
import { el } from '../panel/parts/dom';
import { Scene } from '../scene';

/** A scene and the canvas on which it draws. */
export interface Drawer {
  readonly scene: Scene;
  readonly canvas: HTMLCanvasElement;
  readonly quality: Drawing['quality'];
}

/** Time for which the page shows the notice before the shapes are made, which stops the page [ms]. */
const SHOWN_MS = 60;

/** Makes a scene; it draws after its canvas has been placed in the page. */
export function drawer(welcome: Welcome, drawing: Drawing): Drawer {
  const canvas = el('canvas', { class: 'scene', 'aria-hidden': 'true' });
  return { scene: new Scene(canvas, welcome, drawing), canvas, quality: drawing.quality };
}

/** Returns the drawer of the first pictures: the full profile starts as the low one. */
export function firstDrawer(welcome: Welcome, drawing: Drawing): Drawer {
  return drawer(welcome, { ...drawing, quality: 'low' });
}

/**
 * Returns the drawer of the full profile when its first picture is ready; throws if `signal` is aborted.
 *
 * @param area area of the pictures that it will draw [px].
 * @param progress called with the fraction that is done, 0 to 1.
 */
export async function fullDrawer(
  welcome: Welcome,
  drawing: Drawing,
  area: number,
  frame: Frame,
  signal: AbortSignal,
  progress: (done: number) => void,
): Promise<Drawer> {
  progress(0);
  await new Promise((resolve) => setTimeout(resolve, SHOWN_MS));
  signal.throwIfAborted();
  const full = drawer(welcome, drawing);
  try {
    full.scene.setPoses(frame, false, performance.now());
    full.scene.setLighting(frame.display.lighting, frame.time_s);
    await full.scene.prepare(area, signal, progress);
  } catch (error) {
    full.scene.dispose();
    throw error;
  }
  return full;
}

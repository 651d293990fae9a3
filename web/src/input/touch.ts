/** Two sticks and two sliders on the screen, moved by fingers or a mouse. */

import { clamp } from '../basics/clamp';
import type { Reading } from './reading';

/** Number of axes: left stick (right, down), left slider (down), right stick (right, down), right slider (right). */
export const TOUCH_AXES = 6;

export class TouchSticks {
  /** Whether the touch sticks are on the screen. */
  shown = false;
  /** Whether the user has hidden the touch sticks; a touch then does not show them again. */
  private refused = false;
  private readonly axes: number[] = Array<number>(TOUCH_AXES).fill(0);
  /** Fingers that move an axis, by the browser's number. */
  private readonly fingers = new Set<number>();

  /** Called when the screen is touched; shows the touch sticks unless the user has hidden them. */
  touched(): void {
    if (!this.refused) this.shown = true;
  }

  show(): void {
    this.shown = true;
  }

  hide(): void {
    this.shown = false;
    this.refused = true;
    this.release();
  }

  press(finger: number): void {
    this.fingers.add(finger);
  }

  /** Sets an axis to a value in [-1, 1]. After `release`, a finger must be lifted before it moves an axis again. */
  put(finger: number, axis: number, value: number): void {
    if (this.fingers.has(finger)) this.axes[axis] = clamp(value);
  }

  /** Centres the axes that a finger has moved. */
  lift(finger: number, axes: readonly number[]): void {
    for (const axis of axes) this.put(finger, axis, 0);
    this.fingers.delete(finger);
  }

  value(axis: number): number {
    return this.axes[axis] ?? 0;
  }

  /** Centres all axes. */
  release(): void {
    this.fingers.clear();
    this.axes.fill(0);
  }

  /** Returns the reading of the touch sticks; null if they are not on the screen. */
  reading(): Reading | null {
    return this.shown ? { axes: [...this.axes], buttons: [] } : null;
  }
}

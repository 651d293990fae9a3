/** Two sticks and two sliders on the screen: where fingers, or a mouse, have put them. */

import { clamp } from '../basics/clamp';
import type { Reading } from './device';

/** Left stick right, down; left slider down; right stick right, down; right slider right. */
export const TOUCH_AXES = 6;

export class TouchSticks {
  /** On the screen, where they can be moved. */
  shown = false;
  /** They were sent away, and come back only when asked for. */
  private refused = false;
  private readonly axes: number[] = Array<number>(TOUCH_AXES).fill(0);

  /** Offer touch sticks: the screen was touched. */
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

  /** Puts an axis to a value in [-1, 1]. */
  put(axis: number, value: number): void {
    this.axes[axis] = clamp(value);
  }

  value(axis: number): number {
    return this.axes[axis] ?? 0;
  }

  /** All spring back. */
  release(): void {
    this.axes.fill(0);
  }

  /** What they show now; null: they are not on the screen. */
  reading(): Reading | null {
    return this.shown ? { axes: [...this.axes], buttons: [] } : null;
  }
}

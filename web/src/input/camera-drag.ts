/** Turns a camera by a drag in its picture: the length of the drag sets the deflection of the camera's switches. */

import { clamp } from '../basics/clamp';
import { STILL, type Turning } from './camera-hand';

/** Length of a drag for full rate [picture heights], and greatest length without effect [px]. */
const TRAVEL = 0.35;
const SLACK = 4;
/** Time for which one notch of the wheel zooms, and greatest time for several notches together [ms]. */
const NOTCH_MS = 120;
const MOST_MS = 480;
/** Two fingers zoom at full rate if their distance is twice or half their distance at the start. */
const PINCH = Math.log(2);

interface Finger {
  readonly begun: Place;
  at: Place;
}

export interface Place {
  readonly x: number;
  readonly y: number;
}

export class CameraDrag {
  private readonly fingers = new Map<number, Finger>();
  private height = 1;
  private wheel = { zoom: 0, until: 0 };

  /** Starts a drag by a finger or a mouse button; `height`: height of the picture [px]. */
  press(id: number, at: Place, height: number): void {
    this.height = height;
    this.fingers.set(id, { begun: at, at });
  }

  move(id: number, at: Place): void {
    const finger = this.fingers.get(id);
    if (finger) finger.at = at;
  }

  lift(id: number): void {
    this.fingers.delete(id);
  }

  /** Adds a notch of the wheel at `now` [ms]; `zoom`: 1 in, -1 out. */
  turnWheel(zoom: 1 | -1, now: number): void {
    const left = this.wheel.zoom === zoom ? Math.max(0, this.wheel.until - now) : 0;
    this.wheel = { zoom, until: now + Math.min(MOST_MS, left + NOTCH_MS) };
  }

  /** Start and end of the present drag by one finger; null without a drag, or if two fingers pinch. */
  get line(): { readonly from: Place; readonly to: Place } | null {
    const [finger, other] = this.fingers.values();
    return finger && !other ? { from: finger.begun, to: finger.at } : null;
  }

  /** Deflections of the switches at `now` [ms]. */
  turning(now: number): Turning {
    const zoom = now < this.wheel.until ? this.wheel.zoom : 0;
    const [finger, other] = this.fingers.values();
    if (finger && other) return { ...STILL, zoom: clamp(pinched(finger, other) / PINCH) };
    if (!finger) return { ...STILL, zoom };
    const push = (by: number) => clamp(Math.abs(by) < SLACK ? 0 : by / (TRAVEL * this.height));
    return { pan: push(finger.at.x - finger.begun.x), tilt: push(finger.begun.y - finger.at.y), zoom };
  }
}

/** Returns the logarithm of a ratio: the present distance of two fingers over their distance at the start. */
function pinched(a: Finger, b: Finger): number {
  const apart = (one: Place, two: Place) => Math.max(1, Math.hypot(one.x - two.x, one.y - two.y));
  return Math.log(apart(a.at, b.at) / apart(a.begun, b.begun));
}

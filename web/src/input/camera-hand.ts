/** The switches that turn the selected camera, by keys, devices or drags. */

import { clamp } from '../basics/clamp';
import type { Camera } from '../link/protocol';
import type { Command } from '../link/socket';
import type { Mapping } from './mapping';

/** Pan to the right, tilt upwards, zoom in, each in [-1, 1]. */
export interface Turning {
  readonly pan: number;
  readonly tilt: number;
  readonly zoom: number;
}

/** Time between two readings of the switches; greatest time between two messages while a switch is deflected [ms]. */
const TICK_MS = 15;
const REPEAT_MS = 100;
/** Rate of rotation of an engineering view [rad/s], and factor by which its distance changes in a second. */
const ROUND = 0.8;
const NEARER = 2.5;
const LONGEST_S = 0.1;
export const STILL: Turning = { pan: 0, tilt: 0, zoom: 0 };

export interface CameraHandListener {
  /** The selected camera, and whether its drives turn slowly. */
  hand(): { readonly camera: Camera; readonly slow: boolean };
  /** Reason why this page cannot turn cameras, in a sentence; empty if it can. */
  barred(): string;
  /** Adds a sentence to the log; called once for each deflection of the switches. */
  say(text: string): void;
  send(command: Command): void;
  /** Rotates an engineering view to the right and upwards [rad], and brings it nearer by a factor. */
  orbit(camera: Camera, right: number, upwards: number, nearer: number): void;
}

export class CameraHand {
  private readonly timer: number;
  private sent: Omit<Extract<Command, { type: 'drive_camera' }>, 'type'> | null = null;
  private sentAt = 0;
  private pushed = false;
  private last = performance.now();

  /** `read` returns the present positions of the switches. */
  constructor(
    private readonly read: () => Turning,
    private readonly listener: CameraHandListener,
  ) {
    this.timer = window.setInterval(() => this.tick(performance.now()), TICK_MS);
  }

  /** Reads the switches at `now` [ms] and sends changes. */
  tick(now: number): void {
    const dt = Math.min(LONGEST_S, (now - this.last) / 1000);
    this.last = now;
    const { camera, slow } = this.listener.hand();
    const read = document.hidden ? STILL : this.read();
    if (camera.kind === 'engineering') {
      if (isTurning(read)) {
        this.listener.orbit(
          camera,
          read.pan * ROUND * dt,
          read.tilt * ROUND * dt,
          NEARER ** (read.zoom * dt),
        );
      }
      this.drive(null, now);
    } else {
      const pushed = isTurning(read);
      const why = pushed ? (camera.drive ? this.listener.barred() : `${camera.name} is fixed.`) : '';
      if (why && !this.pushed) this.listener.say(why);
      this.pushed = pushed;
      this.drive(pushed && !why ? { camera: camera.name, ...read, slow } : null, now);
    }
  }

  dispose(): void {
    clearInterval(this.timer);
  }

  /** Sends a camera's deflections (null: all zero) if they have changed, or if the last message is old. */
  private drive(turned: typeof this.sent, now: number): void {
    const { sent } = this;
    if (!turned) {
      if (sent) this.transmit({ ...sent, ...STILL }, null, now);
      return;
    }
    const changed =
      !sent || Object.entries(turned).some(([name, value]) => sent[name as keyof typeof sent] !== value);
    if (changed || now - this.sentAt >= REPEAT_MS) this.transmit(turned, turned, now);
  }

  private transmit(command: NonNullable<typeof this.sent>, kept: typeof this.sent, now: number): void {
    this.listener.send({ type: 'drive_camera', ...command });
    this.sent = kept;
    this.sentAt = now;
  }
}

/** Returns the deflections of the switches that the held keys command. */
export function turningOf(held: ReadonlySet<string>, { bindings }: Pick<Mapping, 'bindings'>): Turning {
  const turning = { ...STILL };
  for (const code of held) {
    const use = bindings[code] ?? '';
    const axis = use.slice(1);
    if (axis === 'pan' || axis === 'tilt' || axis === 'zoom') turning[axis] += use.startsWith('-') ? -1 : 1;
  }
  return turning;
}

/** Returns the sum of two deflections of the same switches, limited to full deflection. */
export function together(a: Turning, b: Turning): Turning {
  return { pan: clamp(a.pan + b.pan), tilt: clamp(a.tilt + b.tilt), zoom: clamp(a.zoom + b.zoom) };
}

function isTurning({ pan, tilt, zoom }: Turning): boolean {
  return pan !== 0 || tilt !== 0 || zoom !== 0;
}

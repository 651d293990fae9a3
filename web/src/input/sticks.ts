/** The hand controllers as this page sends them to the station. */

import type { Latency } from '../link/latency';
import type { Vec3 } from '../link/protocol';
import type { Command } from '../link/socket';
import { STILL, type Turning } from './camera-hand';
import type { Controllers } from './controllers';
import {
  type Deflection,
  equal,
  isZero,
  PAN,
  PITCH,
  ROLL,
  TELESCOPE,
  TILT,
  X,
  Y,
  YAW,
  Z,
  ZERO,
  ZOOM,
} from './deflection';

/** Greatest time between two messages while sticks are deflected or RATE HOLD is on [ms]; the station allows 0.5 s. */
const REPEAT_MS = 100;

/** Zero deflection of all stick axes; the axes of the camera are not included. */
const REST: Deflection = ZERO.slice(0, PAN);

export class Sticks {
  /** Whether X drives the selected joint (SINGLE, DIRECT). */
  driving = false;
  /** Whether RATE HOLD is on; the station then needs regular messages even if the sticks are centred. */
  kept = false;
  /** Deflections for the selected camera. */
  camera: Turning = STILL;
  private orbiter = false;
  private last = 0;
  private sentAt = 0;
  private sent: Deflection = REST;

  constructor(
    private readonly controllers: Controllers,
    private readonly latency: Latency,
    private readonly send: (command: Command) => number,
  ) {}

  /** Deflections as last sent. */
  get value(): Deflection {
    return this.sent;
  }

  /** Whether the THC is assigned to the orbiter, not to the arm. */
  get flyingOrbiter(): boolean {
    return this.orbiter;
  }

  /** Assigns the THC to the orbiter or to the arm, with the sticks at zero. */
  flyOrbiter(on: boolean): void {
    this.zero();
    this.orbiter = on;
  }

  /** Called for an input at `at` [ms]: reads the devices and sends changes at once, not at the next tick. */
  moved(at: number): void {
    this.read(Math.max(performance.now(), this.last + 16), at);
  }

  /** Reads the devices at `now` [ms] and sends changes. */
  tick(now: number): void {
    this.read(now, null);
  }

  /**
   * `inputAt`: time of a key's press or release [ms]; null if no key event caused the call. If it is null, a change of
   * a device other than the keyboard has the time `now`.
   */
  private read(now: number, inputAt: number | null): void {
    const dt = Math.min(0.1, Math.max(0, (now - this.last) / 1000));
    this.last = Math.max(now, this.last);
    const all = this.controllers.poll(now, dt).map((part) => Math.round(part * 1000) / 1000);
    this.camera = { pan: all[PAN] ?? 0, tilt: all[TILT] ?? 0, zoom: all[ZOOM] ?? 0 };
    const value = all.slice(0, PAN);
    const { pulses } = this.controllers;
    if (pulses.asks) this.send({ type: 'pulse', ...routed(pulses.pushed, this.driving, this.orbiter) });
    const changed = !equal(value, this.sent);
    const speaks = this.kept || !isZero(value);
    if (!changed && !(speaks && now - this.sentAt >= REPEAT_MS)) return;
    const seq = this.transmit(value, now);
    const from = inputAt ?? (this.controllers.moved ? now : null);
    // A latency is measured only if the sticks have changed: a camera key, for example, changes no stick.
    if (changed && from !== null) this.latency.sent(seq, from);
  }

  /**
   * Centres the sticks at once. Then a key acts only when pressed again, and another device only after it was at zero.
   */
  zero(): void {
    this.controllers.release();
    this.camera = STILL;
    if (!isZero(this.sent)) this.transmit(REST, performance.now());
  }

  private transmit(value: Deflection, now: number): number {
    this.sent = value;
    this.sentAt = now;
    return this.send({ type: 'sticks', ...routed(value, this.driving, this.orbiter) });
  }
}

/** Returns the stick axes by channel. `driving`: X drives one joint; `orbiter`: the THC translates the orbiter. */
export function routed(value: Deflection, driving: boolean, orbiter: boolean) {
  const at = (axis: number) => value[axis] ?? 0;
  const none: Vec3 = [0, 0, 0];
  const thc: Vec3 = [at(X), at(Y), at(Z)];
  const rhc: Vec3 = [at(ROLL), at(PITCH), at(YAW)];
  return {
    translation: driving || orbiter ? none : thc,
    rotation: driving ? none : rhc,
    drive: driving && !orbiter ? at(X) : 0,
    telescope: at(TELESCOPE),
    orbiter: orbiter ? thc : none,
  };
}

/** Keyboard and pad merged into one pair of hand controllers, and sent to the station. */

import type { Latency } from '../latency';
import type { Vec3 } from '../protocol';
import type { Command } from '../socket';
import {
  type Deflection,
  equal,
  isZero,
  map,
  PITCH,
  ROLL,
  sum,
  TELESCOPE,
  X,
  Y,
  YAW,
  Z,
  ZERO,
} from './deflection';
import type { Pad } from './gamepad';
import type { Keyboard } from './keyboard';

/** Deflected sticks are sent at least this often [ms]; the station zeroes silent ones after 0.5 s. */
const REPEAT_MS = 100;

export class Sticks {
  /** X drives the selected joint (SINGLE, DIRECT). */
  driving = false;
  private orbiter = false;
  private last = 0;
  private sentAt = 0;
  private sent: Deflection = ZERO;
  private padWas: Deflection = ZERO;
  private inputAt: number | null = null;

  constructor(
    private readonly keyboard: Keyboard,
    private readonly pad: Pad,
    private readonly latency: Latency,
    private readonly send: (command: Command) => number,
  ) {}

  /** Where the sticks stand, as last sent. */
  get value(): Deflection {
    return this.sent;
  }

  /** The THC flies the orbiter, not the arm. */
  get flyingOrbiter(): boolean {
    return this.orbiter;
  }

  /** Hands the THC to the orbiter or back to the arm, with the sticks at zero. */
  flyOrbiter(on: boolean): void {
    this.zero();
    this.orbiter = on;
  }

  /** A key went down or up at `at` [ms]; the answer shall not wait for the next tick. */
  moved(at: number): void {
    this.inputAt ??= at;
    this.tick(Math.max(performance.now(), this.last + 16));
  }

  /** Reads the devices at `now` [ms] and sends what changed. */
  tick(now: number): void {
    const dt = Math.min(0.1, Math.max(0, (now - this.last) / 1000));
    this.last = Math.max(now, this.last);
    const stateBefore = this.pad.state;
    const pad = this.pad.poll();
    if (this.pad.state === 'lost' && stateBefore !== 'lost') this.keyboard.release();
    if (!equal(pad, this.padWas)) this.inputAt ??= now;
    this.padWas = pad;
    const both = sum(this.keyboard.step(dt), pad);
    const value = map((axis) => Math.round((both[axis] ?? 0) * 1000) / 1000);
    const changed = !equal(value, this.sent);
    if (changed || (!isZero(value) && now - this.sentAt >= REPEAT_MS)) this.transmit(value, now);
  }

  /** Zeroes the sticks at once; held keys must be pressed anew, the pad seen at zero. */
  zero(): void {
    this.keyboard.release();
    this.pad.disarm();
    this.padWas = ZERO;
    if (!isZero(this.sent)) this.transmit(ZERO, performance.now());
  }

  private transmit(value: Deflection, now: number): void {
    const seq = this.send({ type: 'sticks', ...routed(value, this.driving, this.orbiter) });
    if (this.inputAt !== null) this.latency.sent(seq, this.inputAt);
    this.inputAt = null;
    this.sent = value;
    this.sentAt = now;
  }
}

/** What each stick axis moves; `driving`: one joint; `orbiter`: the THC translates the orbiter. */
export function routed(value: Deflection, driving: boolean, orbiter: boolean) {
  const none: Vec3 = [0, 0, 0];
  const thc: Vec3 = [value[X], value[Y], value[Z]];
  const rhc: Vec3 = [value[ROLL], value[PITCH], value[YAW]];
  return {
    translation: driving || orbiter ? none : thc,
    rotation: driving ? none : rhc,
    drive: driving && !orbiter ? value[X] : 0,
    telescope: value[TELESCOPE],
    orbiter: orbiter ? thc : none,
  };
}

/**
 * PULSE: while it is on, the sticks' axes do not deflect the sticks; each push of an axis asks the station for one pulse,
 * which moves the arm by a small fixed distance or angle. An axis that is deflected when PULSE changes acts only after it
 * was centred, so that no change of PULSE starts a motion.
 */

import { type Deflection, isZero, PAN, ZERO } from './deflection';

/** Deflection from which on an axis asks for a pulse, and deflection below which it can ask for the next one. */
const PUSHED = 0.5;
const BACK = 0.25;

export class Pulses {
  /** Whether PULSE was switched on, on the desk or with a button. */
  on = false;
  /** Whether PULSE is on: it was switched on, or its key is held. */
  active = false;
  /** Directions in which the last reading asks for pulses: −1, 0 or 1 for each axis. */
  pushed: Deflection = ZERO;
  /** Axes that must be centred before they act again. */
  private waiting: readonly boolean[] = ZERO.map(() => false);

  /** Returns the deflections that are left of a reading; `held`: whether the key of PULSE is held. */
  take(value: Deflection, held: boolean): Deflection {
    const active = this.on || held;
    const changed = active !== this.active;
    this.active = active;
    const arm = (axis: number) => (axis < PAN ? (value[axis] ?? 0) : 0);
    const back = active ? BACK : 0;
    this.waiting = ZERO.map((_, axis) =>
      changed ? arm(axis) !== 0 : this.waiting[axis] === true && Math.abs(arm(axis)) > back,
    );
    this.pushed = ZERO;
    if (active) {
      this.pushed = ZERO.map((_, axis) =>
        !this.waiting[axis] && Math.abs(arm(axis)) >= PUSHED ? Math.sign(arm(axis)) : 0,
      );
      this.waiting = this.waiting.map((waits, axis) => waits || this.pushed[axis] !== 0);
    }
    return value.map((part, axis) => (axis < PAN && (active || this.waiting[axis]) ? 0 : part));
  }

  /** Whether the last reading asks for a pulse. */
  get asks(): boolean {
    return !isZero(this.pushed);
  }
}

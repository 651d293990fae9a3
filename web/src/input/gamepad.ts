/** One pad with the browser's standard mapping as both hand controllers. */

import { type Deflection, isZero, ZERO } from './deflection';
import type { Action } from './keymap';

const DEADBAND = 0.08;
const EXPO = 0.3;

/** `none`: never seen · `waiting`: not yet seen at zero · `flying` · `lost`: gone while it was ours. */
export type PadState = 'none' | 'waiting' | 'flying' | 'lost';

/** An axis after deadband and expo. */
export function shape(raw: number): number {
  const size = Math.min(1, Math.max(0, (Math.abs(raw) - DEADBAND) / (1 - DEADBAND)));
  return Math.sign(raw) * ((1 - EXPO) * size + EXPO * size ** 3);
}

/** Sticks: left X, Y; triggers up, down; right pitch, yaw; bumpers roll. */
export function deflection(pad: Gamepad): Deflection {
  const axis = (index: number) => shape(pad.axes[index] ?? 0);
  const trigger = (index: number) => shape(pad.buttons[index]?.value ?? 0);
  const button = (index: number) => (pad.buttons[index]?.pressed ? 1 : 0);
  // A pad's axes grow downwards; a stick pushed away is +X and nose up.
  const x = 0 - axis(1);
  const pitch = 0 - axis(3);
  return [x, axis(0), trigger(7) - trigger(6), button(5) - button(4), pitch, axis(2)];
}

/** South, east, west, view, menu. */
const BUTTONS: ReadonlyMap<number, Action> = new Map<number, Action>([
  [0, { name: 'rate' }],
  [1, { name: 'stop' }],
  [2, { name: 'rate hold' }],
  [8, { name: 'other monitor' }],
  [9, { name: 'step camera', by: 1 }],
]);

export class Pad {
  state: PadState = 'none';
  /** The device as the browser names it; empty before the first. */
  name = '';
  private down = new Set<number>();

  constructor(private readonly acted: (action: Action) => void) {}

  /** Reads the pad now; anything but a flying pad is at zero. */
  poll(): Deflection {
    const pad = navigator.getGamepads().find((each) => each?.connected && each.mapping === 'standard');
    if (!pad) {
      if (this.state === 'flying' || this.state === 'waiting') this.state = 'lost';
      this.down.clear();
      return ZERO;
    }
    this.name = pad.id;
    if (this.state === 'none' || this.state === 'lost') this.state = 'waiting';
    this.press(pad);
    const value = deflection(pad);
    if (this.state === 'waiting' && isZero(value)) this.state = 'flying';
    return this.state === 'flying' ? value : ZERO;
  }

  /** Takes control away until the pad was seen at zero. */
  disarm(): void {
    if (this.state === 'flying') this.state = 'waiting';
  }

  /** The operator knows that the pad is gone. */
  acknowledge(): void {
    if (this.state === 'lost') this.state = 'none';
  }

  private press(pad: Gamepad): void {
    for (const [index, action] of BUTTONS) {
      const pressed = pad.buttons[index]?.pressed ?? false;
      if (pressed && !this.down.has(index)) this.acted(action);
      if (pressed) this.down.add(index);
      else this.down.delete(index);
    }
  }
}

/** One pad with the browser's standard mapping as both hand controllers; Menu held gives its buttons a second use. */

import { type Deflection, isZero, ZERO } from './deflection';
import type { Action, Grip } from './keymap';

const DEADBAND = 0.08;
const EXPO = 0.3;

/** Buttons of the standard mapping. */
const [SOUTH, EAST, WEST, NORTH] = [0, 1, 2, 3];
const [VIEW, MENU] = [8, 9];
const [CROSS_UP, CROSS_DOWN] = [12, 13];

/** `none`: never seen · `waiting`: not yet seen at zero · `flying` · `lost`: gone while it was ours. */
export type PadState = 'none' | 'waiting' | 'flying' | 'lost';

/** An axis after deadband and expo. */
export function shape(raw: number): number {
  const size = Math.min(1, Math.max(0, (Math.abs(raw) - DEADBAND) / (1 - DEADBAND)));
  return Math.sign(raw) * ((1 - EXPO) * size + EXPO * size ** 3);
}

/** Sticks: left X, Y; triggers up, down; right pitch, yaw; bumpers roll. Menu and the cross: the telescope. */
export function deflection(pad: Gamepad): Deflection {
  const axis = (index: number) => shape(pad.axes[index] ?? 0);
  const trigger = (index: number) => shape(pad.buttons[index]?.value ?? 0);
  const button = (index: number) => (pad.buttons[index]?.pressed ? 1 : 0);
  // A pad's axes grow downwards; a stick pushed away is +X and nose up.
  const x = 0 - axis(1);
  const pitch = 0 - axis(3);
  const telescope = button(MENU) * (button(CROSS_UP) - button(CROSS_DOWN));
  return [x, axis(0), trigger(7) - trigger(6), button(5) - button(4), pitch, axis(2), telescope + 0];
}

/** What a button does: something once, or a grip for as long as it is down. */
type Use = Exclude<Action, { readonly name: 'grip' }> | Grip;

const ALONE: ReadonlyMap<number, Use> = new Map<number, Use>([
  [SOUTH, { name: 'rate' }],
  [EAST, { name: 'stop' }],
  [WEST, { name: 'rate hold' }],
  [NORTH, 'close'],
  [VIEW, { name: 'other monitor' }],
]);

/** East stays stop, whatever else is held. */
const WITH_MENU: ReadonlyMap<number, Use> = new Map<number, Use>([
  [SOUTH, 'latch'],
  [EAST, { name: 'stop' }],
  [WEST, { name: 'plane' }],
  [NORTH, 'open'],
  [VIEW, { name: 'fly orbiter' }],
]);

export class Pad {
  state: PadState = 'none';
  /** The device as the browser names it; empty before the first. */
  name = '';
  /** Buttons down, each with the use that it went down for. */
  private readonly down = new Map<number, Use | undefined>();
  /** Menu is down and nothing else was pressed with it. */
  private menuAlone = false;

  constructor(private readonly acted: (action: Action) => void) {}

  /** Reads the pad now; anything but a flying pad is at zero. */
  poll(): Deflection {
    const pad = navigator.getGamepads().find((each) => each?.connected && each.mapping === 'standard');
    if (!pad) {
      if (this.state === 'flying' || this.state === 'waiting') this.state = 'lost';
      this.letGo();
      return ZERO;
    }
    this.name = pad.id;
    if (this.state === 'none' || this.state === 'lost') this.state = 'waiting';
    this.press(pad);
    const value = deflection(pad);
    if (this.state === 'waiting' && isZero(value)) this.state = 'flying';
    return this.state === 'flying' ? value : ZERO;
  }

  /** Takes control away until the pad was seen at zero; a button held must be pressed anew. */
  disarm(): void {
    if (this.state === 'flying') this.state = 'waiting';
    for (const [index, use] of this.down) {
      this.down.set(index, undefined);
      this.end(use);
    }
  }

  /** The operator knows that the pad is gone. */
  acknowledge(): void {
    if (this.state === 'lost') this.state = 'none';
  }

  private press({ buttons }: Gamepad): void {
    const menu = buttons[MENU]?.pressed ?? false;
    if (menu && !this.down.has(MENU)) this.menuAlone = true;
    for (const [index, { pressed }] of buttons.entries()) {
      if (pressed === this.down.has(index)) continue;
      if (pressed) {
        const use = (menu ? WITH_MENU : ALONE).get(index);
        this.down.set(index, use);
        if (index !== MENU) this.menuAlone = false;
        this.begin(use);
      } else {
        const use = this.down.get(index);
        this.down.delete(index);
        this.end(use);
        if (index === MENU && this.menuAlone) this.acted({ name: 'step camera', by: 1 });
      }
    }
  }

  private begin(use: Use | undefined): void {
    if (typeof use === 'string') this.acted({ name: 'grip', grip: use, down: true, at: performance.now() });
    else if (use) this.acted(use);
  }

  private end(use: Use | undefined): void {
    if (typeof use === 'string') this.acted({ name: 'grip', grip: use, down: false, at: performance.now() });
  }

  /** The pad is gone: nothing is held any more. */
  private letGo(): void {
    const uses = [...this.down.values()];
    this.down.clear();
    this.menuAlone = false;
    for (const use of uses) this.end(use);
  }
}

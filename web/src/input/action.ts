/** What a press of a key or button asks for. */

import type { Use } from '../link/protocol';

/** Functions that act after a hold: close or open the end effector, latch or unlatch a payload, release the brakes. */
export type Grip = 'close' | 'open' | 'latch' | 'brakes';

/** A function that acts at once, or the key map (`?`, which cannot be assigned), or a function that acts after a hold. */
export type Action = { readonly name: Use | 'keys' } | GripAction;

export interface GripAction {
  readonly name: 'grip';
  readonly grip: Grip;
  readonly down: boolean;
  /** Time of the press or release [ms, as performance.now()]. */
  readonly at: number;
}

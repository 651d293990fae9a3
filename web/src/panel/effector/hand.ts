/** Interface of the two kinds of end effector on the desk. */

import type { Names } from '../../input/active-device';
import type { Hand as HandState } from '../../link/protocol';
import type { Units } from '../../words/units';
import type { HoldButton } from '../parts/hold-button';

/** Hold times of the buttons that capture or close, and of the buttons that release or open [s]. */
export const CLOSE_S = 0.3;
export const OPEN_S = 1;

/** One kind of end effector. */
export interface Hand {
  readonly element: HTMLElement;
  /** Buttons that close and open the end effector; each acts after a hold. */
  readonly close: HoldButton;
  readonly open: HoldButton;
  /** Returns whether the end effector moves. A press of either button then stops it at once. */
  moves(hand: HandState): boolean;
  /** `names`: those of the device in use. */
  bars(hand: HandState, names: Names): void;
  set(hand: HandState, units: Units): void;
}

/** Interface of the two kinds of end effector on the desk. */

import type { Hand as HandState } from '../../link/protocol';
import type { Units } from '../../words/units';
import type { HoldButton } from '../parts/hold-button';

/** Times to hold a button to capture or close, and to release or open [s]. */
export const CLOSE_S = 0.3;
export const OPEN_S = 1;

/** One kind of end effector. */
export interface Hand {
  readonly element: HTMLElement;
  /** Buttons that close it and open it; each acts after it was held for a time. */
  readonly close: HoldButton;
  readonly open: HoldButton;
  /** Whether it moves; a press of either button then stops it at once. */
  moves(hand: HandState): boolean;
  bars(hand: HandState): void;
  set(hand: HandState, units: Units): void;
}

/** What the desk's groups have in common: they draw one frame, and hold nothing of the arm themselves. */

import type { ControllersShown } from '../../input/controllers';
import type { Deflection } from '../../input/deflection';
import type { Frame, Welcome } from '../../link/protocol';
import type { Command } from '../../link/socket';
import type { Units } from '../../words/units';

/** All that a part draws from. */
export interface View {
  readonly frame: Frame;
  readonly units: Units;
  /** Deflections of this page's own sticks. */
  readonly hand: Deflection;
  /** Description of the devices that move them. */
  readonly controllers: ControllersShown;
  /** What the page that flies is called, at the beginning of a sentence; empty: no page flies; null: a recording, which does not tell. */
  readonly flier: string | null;
  /** This page holds the sticks. */
  readonly flying: boolean;
  /** This page's THC flies the orbiter. */
  readonly orbiting: boolean;
}

export interface Part {
  readonly element: HTMLElement;
  /** Marks and bars, at picture rate. */
  bars?(view: View): void;
  /** Figures and legends, ten times a second. */
  values?(view: View): void;
}

/** What the parts may do. */
export interface Desk {
  readonly welcome: Welcome;
  send(command: Command): void;
  /** A line of the page's own in the log. */
  say(text: string): void;
}

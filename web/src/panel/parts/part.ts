/** Interface of the desk's groups. A group draws a frame and stores no state of the arm. */

import type { ControllersShown } from '../../input/controllers';
import type { Deflection } from '../../input/deflection';
import type { Frame, Use, Welcome } from '../../link/protocol';
import type { Command } from '../../link/socket';
import type { Units } from '../../words/units';

/** Data from which a part of the page is drawn. */
export interface View {
  readonly frame: Frame;
  readonly units: Units;
  /** Deflections of this page's own sticks. */
  readonly hand: Deflection;
  /** Description of the devices that move this page's sticks. */
  readonly controllers: ControllersShown;
  /** Name of the operator, for the start of a sentence; empty if unattended; null in a replay (no name is recorded). */
  readonly flier: string | null;
  /** Whether this page is in control. */
  readonly flying: boolean;
  /** Whether this page's THC is assigned to the orbiter. */
  readonly orbiting: boolean;
}

export interface Part {
  readonly element: HTMLElement;
  /** Draws marks and bars, at picture rate. */
  bars?(view: View): void;
  /** Writes numbers and legends, ten times a second. */
  values?(view: View): void;
}

/** Functions and data that all groups use. */
export interface Desk {
  readonly welcome: Welcome;
  send(command: Command): void;
  /** Does what the key of a function does. */
  act(use: Use): void;
  /** Adds a line to the page's log. */
  say(text: string): void;
}

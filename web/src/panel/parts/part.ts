/** Interface of the desk's groups: they draw one frame, and keep no state of the arm. */

import type { ControllersShown } from '../../input/controllers';
import type { Deflection } from '../../input/deflection';
import type { Frame, Welcome } from '../../link/protocol';
import type { Command } from '../../link/socket';
import type { Units } from '../../words/units';

/** Data that a part draws. */
export interface View {
  readonly frame: Frame;
  readonly units: Units;
  /** Deflections of this page's own sticks. */
  readonly hand: Deflection;
  /** Description of the devices that move them. */
  readonly controllers: ControllersShown;
  /** Name of the operator, for the start of a sentence; empty if unattended; null for a recording, which contains no name. */
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
  /** Writes figures and legends, ten times a second. */
  values?(view: View): void;
}

/** Services for the parts. */
export interface Desk {
  readonly welcome: Welcome;
  send(command: Command): void;
  /** Adds a line of the page's own to the log. */
  say(text: string): void;
}

/** What functions of keys and buttons act on. */

import type { Frame } from '../../link/protocol';
import type { Command } from '../../link/socket';

interface Toggled {
  toggle(): void;
}

/** Pictures of a page or of a secondary window. */
export interface Viewing {
  readonly pictures: {
    readonly monitors: {
      /** `now`: time of the press [ms]. */
      chooseDigit(index: number, now: number): void;
      step(by: 1 | -1): void;
      toggleSplit(): void;
    };
  };
  togglePlane(): void;
  toggleBending(): void;
}

/** The operator's page: sends commands, and has parts that change only on the page. */
export interface Acting extends Viewing {
  /** Frame that the numbers show; null before the first. */
  readonly frame: Frame | null;
  readonly pictures: Viewing['pictures'] & {
    readonly monitors: { takeOther(): void; toggleSlow(): void };
    readonly offers: { take(): void };
    toggleMatrix(): void;
  };
  readonly groups: {
    readonly mode: { turn(by: 1 | -1): void; turnJoint(by: 1 | -1): void };
    readonly target: { proceed(): void };
  };
  readonly light: Toggled & { lock(): void };
  readonly controlPage: Toggled;
  readonly console: Toggled;
  /** Sends a command if the page is in control. */
  send(command: Command): void;
  stop(): void;
  /** Enters the selected mode or, if none is selected, the mode that the task needs. */
  enterMode(): void;
  togglePulse(): void;
  acknowledge(): void;
  mute(): void;
  /** Assigns the THC to the orbiter, or to the arm. */
  swapOrbiter(): void;
  /** Closes all sheets and lists. */
  leave(): void;
}

/** Whether this page's sticks move the arm. The page's role, its link, `leaving` and `tooNarrow` decide this. */

import type { Role } from '../link/protocol';
import type { LinkState } from '../link/socket';
import { calledFirst } from '../panel/rail/operator-name';
import { TOO_NARROW_WORDS } from './room';

/** What to do if there is no connection to the station. */
export const NO_CONNECTION = 'Connection lost: check that aftdeck fly still runs, or start it again';

export class Control {
  role: Role = {
    type: 'role',
    flying: false,
    may_fly: true,
    watchers: 0,
    number: 0,
    flier: 0,
    asking: 0,
    name: '',
    names: [],
  };
  link: LinkState = { kind: 'open' };
  /** Whether the station is preparing another scenario; meanwhile the sticks are centred. */
  leaving = false;
  /** Whether the window is too narrow for the controls; the page then only observes. */
  tooNarrow = false;

  get flies(): boolean {
    return this.bar === '';
  }

  /** Reason why this page's sticks do not move the arm, and what to do; empty if they move it. */
  get bar(): string {
    if (this.link.kind === 'preparing') return this.link.text;
    if (this.link.kind !== 'open') return NO_CONNECTION;
    if (this.tooNarrow) return TOO_NARROW_WORDS;
    if (this.leaving) return 'Another scenario is being prepared: the sticks are centred';
    const { flying, may_fly, flier } = this.role;
    if (flying) return '';
    const who = flier === 0 ? 'the station is unattended' : `${calledFirst(this.role, flier)} flies`;
    const what = may_fly
      ? 'Press “Ask for the sticks” in the top rail'
      : 'The address of this page is for observing';
    return `Observing: ${who}. ${what}`;
  }
}

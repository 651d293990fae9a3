/** Whether this page's sticks move the arm. The page's role, its link, `leaving` and `tooNarrow` decide this. */

import type { Role } from '../link/protocol';
import type { LinkState } from '../link/socket';

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
    return this.role.flying && this.link.kind === 'open' && !this.leaving && !this.tooNarrow;
  }
}

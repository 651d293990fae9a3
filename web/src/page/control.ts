/** Whether this page's sticks move the arm: its role, its link to the station, and what keeps it from flying. */

import type { Role } from '../link/protocol';
import type { LinkState } from '../link/socket';

export class Control {
  role: Role = {
    type: 'role',
    flying: false,
    watchers: 0,
    number: 0,
    flier: 0,
    asking: 0,
    name: '',
    names: [],
  };
  link: LinkState = { kind: 'open' };
  /** Another scenario is being made ready: the sticks rest. */
  leaving = false;
  /** The window is too narrow for the controls: the page only observes. */
  tooNarrow = false;

  get flies(): boolean {
    return this.role.flying && this.link.kind === 'open' && !this.leaving && !this.tooNarrow;
  }
}

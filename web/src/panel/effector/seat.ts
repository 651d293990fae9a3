/** The switch that latches a payload in its berth, or unlatches it: retention latches or docking port. */

import type { Work, WorkInfo } from '../../link/protocol';
import { el, setAttribute, setClass, setText } from '../parts/dom';
import { type HoldButton, holdButton } from '../parts/hold-button';
import type { Desk } from '../parts/part';

/** Time to hold a button to latch or to unlatch [s]. */
const LATCH_S = 1;

export interface Seat {
  readonly element: HTMLElement;
  /** Presses the button that applies now, for the key. */
  keyed(): HoldButton;
  /** Releases the button that the key pressed; meanwhile the other one may apply. */
  lift(at: number): void;
  tick(): void;
  set(work: Work): void;
}

export function seat(desk: Desk): Seat {
  const latch = holdButton('Latch', 'latch', LATCH_S, () => desk.send({ type: 'latch', latch: 'latch' }));
  const unlatch = holdButton('Unlatch', 'latch', LATCH_S, () =>
    desk.send({ type: 'latch', latch: 'unlatch' }),
  );
  const where = el('span', { class: 'where' });
  let fixed = false;
  return {
    element: el('div', { class: 'seat' }, latch.element, unlatch.element, where),
    keyed: () => (fixed ? unlatch : latch),
    lift(at) {
      latch.lift(at);
      unlatch.lift(at);
    },
    tick() {
      latch.tick();
      unlatch.tick();
    },
    set(work) {
      const at = seatTitle(desk.welcome.work, seatNow(work));
      fixed = at !== '';
      setText(where, at === '' ? 'in no berth' : at);
      setAttribute(where, 'title', at);
      setClass(latch.element, 'keyed', !fixed);
      setClass(unlatch.element, 'keyed', fixed);
    },
  };
}

/** The berth of the held payload, or else of any payload; empty if it is in none. */
export function seatNow({ cargo }: Pick<Work, 'cargo'>): string {
  const held = cargo.find((each) => each.held);
  return held ? held.seat : (cargo.find((each) => each.seat !== '')?.seat ?? '');
}

/** Title of a berth for display; empty if there is none. */
export function seatTitle({ seats }: Pick<WorkInfo, 'seats'>, name: string): string {
  return seats.find((seat) => seat.name === name)?.title ?? name;
}

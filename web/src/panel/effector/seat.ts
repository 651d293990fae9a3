/** The buttons that latch a payload in its berth and unlatch it, for retention latches and docking ports. */

import type { Names } from '../../input/active-device';
import type { Work, WorkInfo } from '../../link/protocol';
import { el, setAttribute, setClass, setText } from '../parts/dom';
import { type HoldButton, holdButton } from '../parts/hold-button';
import type { Desk } from '../parts/part';

/** Hold time of the buttons [s]. */
const LATCH_S = 1;

export interface Seat {
  readonly element: HTMLElement;
  /** Returns the button on which the latch key acts now: unlatch if `seatNow` returns a berth, else latch. */
  keyed(): HoldButton;
  /** Called when the key is released: releases both buttons, because `keyed` may have changed since the press. */
  lift(at: number): void;
  /** `names`: those of the device in use. */
  tick(names: Names): void;
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
    tick(names) {
      latch.tick(names);
      unlatch.tick(names);
    },
    set(work) {
      const at = seatTitle(desk.welcome.work, seatNow(work));
      fixed = at !== '';
      setText(where, at === '' ? 'not latched' : at);
      setAttribute(where, 'title', at);
      setClass(latch.element, 'keyed', !fixed);
      setClass(unlatch.element, 'keyed', fixed);
    },
  };
}

/**
 * Returns the name of the berth of the held payload or, if no payload is held, of the first payload that is in a berth.
 * Empty if there is no such berth.
 */
export function seatNow({ cargo }: Pick<Work, 'cargo'>): string {
  const held = cargo.find((each) => each.held);
  return held ? held.seat : (cargo.find((each) => each.seat !== '')?.seat ?? '');
}

/** Returns the title of a berth; empty if `name` is empty. */
export function seatTitle({ seats }: Pick<WorkInfo, 'seats'>, name: string): string {
  return seats.find((seat) => seat.name === name)?.title ?? name;
}

/** The payloads of the worksite: what each payload is fixed to, and the speed of a free payload. */

import { small } from '../../words/format';
import { ACTIVITIES } from '../../words/task-phases';
import { el, group, setAbout, setAttribute, setText } from '../parts/dom';
import type { Desk, Part } from '../parts/part';
import { seatTitle } from './seat';

const ROWS = 3;

export function cargoGroup({ welcome }: Desk): Part {
  const rows = welcome.work.cargo.slice(0, ROWS).map((name) => {
    const state = el('span');
    const speed = el('span', { class: 'speed' });
    const row = el('tr', {}, el('th', { scope: 'row', title: name }, name), el('td', {}, state, speed));
    return { name, state, speed, row };
  });
  const table = el('table', {}, el('tbody', {}, ...rows.map(({ row }) => row)));
  const element = group('cargo', rows.length === 1 ? 'Payload' : 'Payloads', table);
  return {
    element,
    values({ frame, units: { creep } }) {
      setAbout(element, ACTIVITIES[frame.work.task - 1] ?? '');
      for (const { name, state, speed } of rows) {
        const cargo = frame.work.cargo.find((each) => each.name === name);
        const seat = cargo ? seatTitle(welcome.work, cargo.seat) : '';
        setText(state, cargo ? whereIs(cargo.held, seat) : '–');
        setAttribute(state, 'title', seat);
        // A held payload moves with the arm, and a berthed payload does not move: only a free payload shows a speed.
        const free = cargo && !cargo.held && cargo.seat === '';
        setText(speed, free ? `${small(Math.hypot(...cargo.velocity), creep)} ${creep.name}` : '');
      }
    },
  };
}

/** Returns what a payload is fixed to: the arm, the berth with the title `seat`, both, or nothing. */
export function whereIs(held: boolean, seat: string): string {
  if (!held) return seat === '' ? 'free' : seat;
  return seat === '' ? 'held' : 'held, fixed';
}

/** The payload table of SPEC 94: limits of the steering with each payload; the captured payload is marked. */

import type { Display, Frame, PayloadInfo, Welcome } from '../../link/protocol';
import { degrees, fixed } from '../../words/format';
import type { Unit, Units } from '../../words/units';
import { el, setAttribute, setClass, setText } from '../parts/dom';

export interface PayloadTable {
  readonly element: HTMLElement;
  set(frame: Frame, units: Units): void;
}

export function payloadTable({ payloads, joints }: Welcome): PayloadTable {
  const [mass, offset, speed] = [el('i'), el('i'), el('i')];
  const head = el(
    'tr',
    {},
    ...[
      ['ID'],
      ['Payload'],
      ['Mass ', mass],
      ['POR from tip ', offset],
      ['Translation ', speed],
      ['Rotation ', el('i', {}, '°/s')],
      ...joints.map(({ label }) => [label]),
    ].map((words) => el('th', { scope: 'col' }, ...words)),
  );
  const rows = payloads.map((payload) => {
    const cells = { mass: el('td'), offset: el('td'), translation: el('td') };
    const row = el(
      'tr',
      {},
      el('td', {}, String(payload.id)),
      el('th', { scope: 'row', title: payload.name }, payload.name),
      cells.mass,
      cells.offset,
      cells.translation,
      el('td', {}, both(payload.rotation, turning)),
      ...payload.coarse.map((rate, i) => el('td', {}, both([rate, payload.vernier[i] ?? 0], turning))),
    );
    return { payload, cells, row };
  });
  const most = joints.map(({ servo }) => turning(servo)).join('  ');
  const element = el(
    'div',
    { class: 'payload-table' },
    el(
      'h3',
      {},
      'Payloads ',
      el('small', {}, 'limits: coarse / vernier; joints in °/s, in SINGLE, DIRECT and MASTER'),
    ),
    el('table', {}, el('thead', {}, head), el('tbody', {}, ...rows.map(({ row }) => row))),
    el('p', {}, `Computed modes limit the joints to the greatest servo rates: ${most} °/s.`),
  );
  return {
    element,
    set(frame, units) {
      setText(mass, units.mass.name);
      setText(offset, units.length.name);
      setText(speed, units.speed.name);
      for (const { payload, cells, row } of rows) {
        const held = payload.id === frame.display.payload_id;
        setClass(row, 'held', held);
        setAttribute(row, 'aria-current', String(held));
        setText(cells.mass, payload.id === 0 ? '–' : figure(payload.mass, units.mass));
        setText(cells.offset, offsetWords(payload, frame.display, units.length));
        setText(
          cells.translation,
          both(payload.translation, (value) => figure(value, units.speed)),
        );
      }
    },
  };
}

/** Returns the text of the vector from the tip to the payload's POR, which is known only for a captured payload. */
function offsetWords({ id }: PayloadInfo, { payload_id, por_offset }: Display, length: Unit): string {
  if (id === 0) return 'at the tip';
  if (id !== payload_id) return 'set by capture';
  return por_offset.map((value) => fixed(value * length.perSi, length.decimals)).join('  ');
}

function both([coarse, vernier]: readonly [number, number], words: (value: number) => string): string {
  return `${words(coarse)} / ${words(vernier)}`;
}

function turning(rate: number): string {
  return degrees(rate, 2, false);
}

function figure(value: number, { perSi, decimals }: Unit): string {
  return fixed(value * perSi, decimals, false);
}

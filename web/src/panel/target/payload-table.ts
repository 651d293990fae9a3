/** The payload table of SPEC 94: limits of the steering with each payload; the captured payload is marked. */

import type { Display, Frame, JointInfo, PayloadInfo, Welcome } from '../../link/protocol';
import { degrees, fixed } from '../../words/format';
import { rateText, rateUnit } from '../../words/joint';
import type { Unit, Units } from '../../words/units';
import { jointHead } from '../joints/joint-head';
import { el, setAttribute, setClass, setText } from '../parts/dom';

export interface PayloadTable {
  readonly element: HTMLElement;
  set(frame: Frame, units: Units): void;
}

export function payloadTable({ payloads, joints }: Welcome): PayloadTable {
  const [mass, offset, speed] = [el('i'), el('i'), el('i')];
  const heads = joints.map((joint) => jointHead(joint, 'col'));
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
    ].map((words) => el('th', { scope: 'col' }, ...words)),
    ...heads.map(({ element }) => element),
  );
  const rows = payloads.map((payload) => {
    const rates = joints.map(() => el('td'));
    const cells = { mass: el('td'), offset: el('td'), translation: el('td'), rates };
    const row = el(
      'tr',
      {},
      el('td', {}, String(payload.id)),
      el('th', { scope: 'row', title: payload.name }, payload.name),
      cells.mass,
      cells.offset,
      cells.translation,
      el('td', {}, both(payload.rotation, turning)),
      ...rates,
    );
    return { payload, cells, row };
  });
  const [legend, most] = [el('small'), el('p')];
  const element = el(
    'div',
    { class: 'payload-table' },
    el('h3', {}, 'Payloads ', legend),
    el('table', {}, el('thead', {}, head), el('tbody', {}, ...rows.map(({ row }) => row))),
    most,
  );
  return {
    element,
    set(frame, units) {
      setText(mass, units.mass.name);
      setText(offset, units.length.name);
      setText(speed, units.speed.name);
      joints.forEach((joint, i) => {
        heads[i]?.set(rateUnit(joint, units).name);
      });
      const names = [...new Set(joints.map((joint) => rateUnit(joint, units).name))];
      setText(
        legend,
        `limits: coarse / vernier; joints in ${names.join(' or ')}, in SINGLE, DIRECT and MASTER`,
      );
      setText(
        most,
        `Computed modes limit the joints to the greatest servo rates: ${servoRates(joints, units)}.`,
      );
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
        joints.forEach((joint, i) => {
          const limits = [payload.coarse[i] ?? 0, payload.vernier[i] ?? 0] as const;
          const cell = cells.rates[i];
          if (cell)
            setText(
              cell,
              both(limits, (value) => rateText(joint, value, units)),
            );
        });
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

/** The greatest servo rates, with a unit after each group of joints that have the same unit: `0.200 m/s, 3.00  3.00 °/s`. */
export function servoRates(joints: readonly Pick<JointInfo, 'servo' | 'slides'>[], units: Units): string {
  return joints
    .map((joint, i) => {
      const { name } = rateUnit(joint, units);
      const next = joints[i + 1];
      const rate = rateText(joint, joint.servo, units);
      if (!next) return `${rate} ${name}`;
      return next.slides === joint.slides ? `${rate}  ` : `${rate} ${name}, `;
    })
    .join('');
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

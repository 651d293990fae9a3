/** Table of all axes: values before and after deadband and expo, and the assigned keys, buttons or axes. */

import { AXES, type Deflection, ZERO } from '../../input/deflection';
import type { Device } from '../../input/device';
import { axisUse } from '../../input/keymap';
import { nameOfSource } from '../../input/layout';
import type { Kind, Mapping } from '../../input/mapping';
import { deflection } from '../../input/reading';
import { mappingOf } from '../../input/store';
import { fixed } from '../../words/format';
import { el, setAttribute, setText, svg } from '../parts/dom';
import { lightCaps, markAsked, type UseCap, useCap } from './use-cap';

const NAMES = [
  'THC X',
  'THC Y',
  'THC Z',
  'RHC roll',
  'RHC pitch',
  'RHC yaw',
  'Telescope',
  'Camera pan',
  'Camera tilt',
  'Camera zoom',
];
/** Half the length of a bar, in the units of its view box. */
const HALF = 50;

interface Row {
  readonly element: HTMLElement;
  show(raw: number, shaped: number): void;
}

export class AxisTable {
  readonly element = el('div', { class: 'axes-live' });
  private caps: readonly UseCap[] = [];
  private rows: readonly Row[] = [];
  private readonly unused = el('p', { class: 'unused' });

  constructor(private readonly asked: (use: string) => void) {}

  fill(kind: Kind): void {
    const caps: UseCap[] = [];
    this.rows = AXES.map((_, axis) => {
      const [minus, plus] = ([-1, 1] as const).map((sign) => useCap(kind, axisUse(axis, sign), this.asked));
      if (!minus || !plus) throw new Error('an axis has two sides');
      caps.push(minus, plus);
      return liveRow(NAMES[axis] ?? '', minus, plus, mappingOf(kind).deadband);
    });
    this.caps = caps;
    const titles = ['', '−', '', '+', kind === 'keyboard' ? 'keys' : 'device', 'sticks'];
    this.element.replaceChildren(
      el('h3', {}, 'Axes'),
      el(
        'table',
        {},
        el(
          'thead',
          {},
          el(
            'tr',
            {},
            ...titles.map((title) => (title === '' ? el('td') : el('th', { scope: 'col' }, title))),
          ),
        ),
        el('tbody', {}, ...this.rows.map(({ element }) => element)),
      ),
      this.unused,
    );
  }

  ask(use: string | null): void {
    markAsked(this.caps, use);
  }

  /** Shows the keyboard. `target` is full deflection while a key is held; `value` reaches it in 0.35 s. */
  keys(target: Deflection, value: Deflection, held: ReadonlySet<string>): void {
    this.rows.forEach((row, axis) => {
      row.show(target[axis] ?? 0, value[axis] ?? 0);
    });
    lightCaps(this.caps, held);
    setText(this.unused, '');
  }

  device(device: Device | null, mapping: Mapping): void {
    const reading = device?.reading;
    const raw = reading ? deflection(reading, mapping, false) : ZERO;
    const shaped = reading ? deflection(reading, mapping) : ZERO;
    this.rows.forEach((row, axis) => {
      row.show(raw[axis] ?? 0, shaped[axis] ?? 0);
    });
    const free = (reading?.axes ?? []).flatMap((value, i) =>
      mapping.bindings[`a${i}`] === undefined && device
        ? [`${nameOfSource(device.kind, `a${i}`)} ${fixed(value, 2)}`]
        : [],
    );
    setText(this.unused, free.length > 0 ? `Not assigned: ${free.join(', ')}` : '');
  }
}

function liveRow(name: string, minus: UseCap, plus: UseCap, deadband: number): Row {
  const [from, width] = [-deadband * HALF, 2 * deadband * HALF];
  const dead = svg('rect', { class: 'zone', x: `${from}`, width: `${width}`, y: '2', height: '10' });
  const fill = svg('rect', { class: 'after', y: '4', height: '6' });
  const tick = svg('line', { class: 'raw', y1: '0', y2: '14' });
  const bar = svg(
    'svg',
    { viewBox: `${-HALF - 2} 0 ${2 * HALF + 4} 14`, preserveAspectRatio: 'none', 'aria-hidden': 'true' },
    svg('rect', { class: 'track', x: String(-HALF), y: '4', width: String(2 * HALF), height: '6' }),
    dead,
    fill,
    tick,
  );
  const [before, after] = [el('td', { class: 'number' }), el('td', { class: 'number after' })];
  const element = el(
    'tr',
    {},
    el('th', { scope: 'row' }, name),
    el('td', { class: 'end' }, minus.element),
    el('td', { class: 'bar' }, bar),
    el('td', {}, plus.element),
    before,
    after,
  );
  return {
    element,
    show(raw, shaped) {
      setAttribute(fill, 'x', (Math.min(0, shaped) * HALF).toFixed(1));
      setAttribute(fill, 'width', (Math.abs(shaped) * HALF).toFixed(1));
      setAttribute(tick, 'x1', (raw * HALF).toFixed(1));
      setAttribute(tick, 'x2', (raw * HALF).toFixed(1));
      setText(before, fixed(raw, 2));
      setText(after, fixed(shaped, 2));
    },
  };
}

/** The telescope under the arm: a row below the joints. */

import type { Names } from '../../input/active-device';
import type { StandInfo } from '../../link/protocol';
import { fixed } from '../../words/format';
import type { Units } from '../../words/units';
import { el, setAttribute, setText, svg } from '../parts/dom';
import { BAR } from './joint-scale';

export interface StandRow {
  readonly element: HTMLElement;
  /** Sets the length [m], at picture rate. */
  point(length: number): void;
  /** `names`: those of the device in use. */
  set(length: number, units: Units, names: Names): void;
}

/** `limits`: least and greatest length, which changes in flight can change. */
export function standRow(limits: StandInfo): StandRow {
  const unit = el('i');
  const value = el('td', { class: 'angle' });
  const keys = [el('small'), el('small')] as const;
  const pointer = svg('path', { class: 'pointer', d: 'M0 11 L4.5 20 H-4.5 Z M-0.9 0 H0.9 V12 H-0.9 Z' });
  const post = (x: number) =>
    svg('rect', { class: 'post', x: String(x - 1), y: '3', width: '2', height: '13' });
  const bar = svg(
    'svg',
    { class: 'joint-bar', viewBox: `-3 0 ${BAR + 6} 20`, preserveAspectRatio: 'none', 'aria-hidden': 'true' },
    svg('rect', { class: 'track', x: '0', y: '7', width: String(BAR), height: '5' }),
    post(0),
    post(BAR),
    pointer,
  );
  const scale = el('td', { class: 'scale' }, bar);
  const element = el(
    'tr',
    { class: 'stand' },
    el('th', { scope: 'row' }, 'Stand ', unit),
    scale,
    value,
    el('td', { class: 'of-limit' }, ...keys),
  );
  return {
    element,
    point(length) {
      const part = (length - limits.least) / (limits.greatest - limits.least);
      setAttribute(pointer, 'transform', `translate(${(part * BAR).toFixed(2)} 0)`);
    },
    set(length, units, names) {
      const shown = (metres: number) => fixed(metres * units.length.perSi, units.length.decimals, false);
      setText(unit, units.length.name);
      setText(value, shown(length));
      setAttribute(
        scale,
        'title',
        `Telescope: ${shown(limits.least)} to ${shown(limits.greatest)} ${units.length.name}`,
      );
      setText(keys[0], `${names.short('+telescope')} longer`);
      setText(keys[1], `${names.short('-telescope')} shorter`);
    },
  };
}

/** The logarithmic gauge of the clearance, with the zones of the thresholds, and marks below the gauge. */

import type { WorkInfo } from '../../link/protocol';
import { small } from '../../words/format';
import type { Units } from '../../words/units';
import { el, setAttribute, setText, svg } from '../parts/dom';
import { FARTHEST, NEAREST, placeOf } from './gap-scale';

/** Length of the gauge. */
const LENGTH = 200;

export interface GapGauge {
  readonly element: HTMLElement;
  /** Displays the clearance [m]; null if none is measured. */
  point(clearance: number | null): void;
  setUnits(units: Units): void;
}

/** `caution` and `warning`: the thresholds [m]. */
export function gapGauge({ caution, warning }: Pick<WorkInfo, 'caution' | 'warning'>): GapGauge {
  const at = (clearance: number) => placeOf(clearance) * LENGTH;
  const zone = (name: string, from: number, to: number) =>
    svg('rect', { class: name, x: String(at(from)), width: String(at(to) - at(from)), y: '4', height: '6' });
  const pointer = svg('path', { class: 'pointer', d: 'M0 9 L4.5 17 H-4.5 Z M-1 1 H1 V10 H-1 Z' });
  const marks = [NEAREST, warning, caution, FARTHEST].map((clearance) => {
    const place = `left: ${((at(clearance) / LENGTH) * 100).toFixed(2)}%`;
    return { clearance, label: el('span', { style: place }) };
  });
  const element = el(
    'div',
    { class: 'gap-scale' },
    svg(
      'svg',
      { viewBox: `-5 0 ${LENGTH + 10} 18`, preserveAspectRatio: 'none', 'aria-hidden': 'true' },
      svg('rect', { class: 'track', x: '0', y: '4', width: String(LENGTH), height: '6' }),
      zone('near', NEAREST, warning),
      zone('reach', warning, caution),
      pointer,
    ),
    el(
      'div',
      { class: 'marks', 'aria-hidden': 'true', 'data-calm': 'clearance' },
      ...marks.map(({ label }) => label),
    ),
  );
  return {
    element,
    point(clearance) {
      setAttribute(pointer, 'visibility', clearance === null ? 'hidden' : 'visible');
      setAttribute(pointer, 'transform', `translate(${at(clearance ?? 0).toFixed(1)} 0)`);
    },
    setUnits({ gap }) {
      marks.forEach(({ clearance, label }, i) => {
        setText(label, i === 0 ? `${small(clearance, gap)} ${gap.name}` : small(clearance, gap));
      });
    },
  };
}

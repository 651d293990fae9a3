/** The logarithmic gauge of the clearance, with the zones of the thresholds, and marks below the gauge. */

import type { WorkInfo } from '../../link/protocol';
import { small } from '../../words/format';
import type { Units } from '../../words/units';
import { el, setAttribute, setStyle, setText, svg } from '../parts/dom';
import { FARTHEST, NEAREST, placeOf } from './gap-scale';

/** Length of the gauge. */
const LENGTH = 200;

export interface GapGauge {
  readonly element: HTMLElement;
  /** Displays the clearance [m]; null if none is measured. */
  point(clearance: number | null): void;
  setUnits(units: Units): void;
}

/** `thresholds`: clearances of caution and warning [m]; changes in flight can change them. */
export function gapGauge(thresholds: Pick<WorkInfo, 'caution' | 'warning'>): GapGauge {
  const at = (clearance: number) => placeOf(clearance) * LENGTH;
  const zone = (name: string) => svg('rect', { class: name, y: '4', height: '6' });
  const [near, reach] = [zone('near'), zone('reach')];
  const span = (rect: SVGElement, from: number, to: number) => {
    setAttribute(rect, 'x', String(at(from)));
    setAttribute(rect, 'width', String(Math.max(at(to) - at(from), 0)));
  };
  const pointer = svg('path', { class: 'pointer', d: 'M0 9 L4.5 17 H-4.5 Z M-1 1 H1 V10 H-1 Z' });
  const marked = () => [NEAREST, thresholds.warning, thresholds.caution, FARTHEST];
  const marks = marked().map(() => el('span'));
  const draw = () => {
    span(near, NEAREST, thresholds.warning);
    span(reach, thresholds.warning, thresholds.caution);
    marked().forEach((clearance, i) => {
      const mark = marks[i];
      if (mark) setStyle(mark, `left: ${((at(clearance) / LENGTH) * 100).toFixed(2)}%`);
    });
  };
  draw();
  const element = el(
    'div',
    { class: 'gap-scale' },
    svg(
      'svg',
      { viewBox: `-5 0 ${LENGTH + 10} 18`, preserveAspectRatio: 'none', 'aria-hidden': 'true' },
      svg('rect', { class: 'track', x: '0', y: '4', width: String(LENGTH), height: '6' }),
      near,
      reach,
      pointer,
    ),
    el('div', { class: 'marks', 'aria-hidden': 'true', 'data-calm': 'clearance' }, ...marks),
  );
  return {
    element,
    point(clearance) {
      setAttribute(pointer, 'visibility', clearance === null ? 'hidden' : 'visible');
      setAttribute(pointer, 'transform', `translate(${at(clearance ?? 0).toFixed(1)} 0)`);
    },
    setUnits({ gap }) {
      draw();
      marked().forEach((clearance, i) => {
        const mark = marks[i];
        if (mark) setText(mark, i === 0 ? `${small(clearance, gap)} ${gap.name}` : small(clearance, gap));
      });
    },
  };
}

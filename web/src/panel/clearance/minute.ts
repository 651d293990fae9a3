/** Curve of the clearance over the last minute, on a linear scale, with the thresholds as lines. */

import type { WorkInfo } from '../../link/protocol';
import { small } from '../../words/format';
import type { Units } from '../../words/units';
import { el, setAttribute, setText, svg } from '../parts/dom';
import { FARTHEST } from './gap-scale';
import { SPAN_S, type Trend } from './trend';

/** Ranges of the linear scale [m]. The smaller range is used if it contains all values of the last minute. */
const RANGES = [1, FARTHEST] as const;

export interface LastMinute {
  readonly element: HTMLElement;
  draw(trend: Trend, now: number, units: Units): void;
}

export function lastMinute(thresholds: Pick<WorkInfo, 'caution' | 'warning'>): LastMinute {
  const curve = svg('path', { class: 'actual' });
  const lines = (['caution', 'warning'] as const).map((name) => ({
    name,
    line: svg('path', { class: name }),
  }));
  const top = el('span', { class: 'top' });
  const element = el(
    'div',
    { class: 'minute', 'data-calm': 'clearance' },
    svg(
      'svg',
      { viewBox: '0 0 1 1', preserveAspectRatio: 'none', 'aria-hidden': 'true' },
      ...lines.map(({ line }) => line),
      curve,
    ),
    top,
    el('span', { class: 'ago' }, `${SPAN_S} s ago`),
    el('span', { class: 'now' }, 'now'),
  );
  return {
    element,
    draw(trend, now, units) {
      const range = RANGES.find((each) => trend.greatest <= each) ?? FARTHEST;
      for (const { name, line } of lines) {
        const height = (1 - thresholds[name] / range).toFixed(4);
        setAttribute(line, 'd', `M0 ${height}H1`);
      }
      setAttribute(curve, 'd', trend.path(now, range));
      const most = `${small(range, units.gap)} ${units.gap.name}`;
      setText(top, most);
      setAttribute(element, 'title', `The last ${SPAN_S} s, from 0 to ${most}`);
    },
  };
}

/** Bars of a value as a fraction of its limit, −1 to 1. */

import { clamp } from '../../basics/clamp';
import { setAttribute, svg } from './dom';

const HALF = 46;

export interface RateBar {
  readonly element: SVGSVGElement;
  set(actual: number, commanded: number): void;
}

export interface LoadBar {
  readonly element: SVGSVGElement;
  set(actual: number): void;
}

/** Bar of a rate; a mark shows the commanded rate. */
export function rateBar(): RateBar {
  const { element, set } = loadBar();
  const mark = svg('path', { class: 'commanded', d: 'M-6 2 L6 2 L0 11 Z' });
  element.append(mark);
  return {
    element,
    set(actual, commanded) {
      set(actual);
      setAttribute(mark, 'transform', `translate(${(50 + HALF * clamp(commanded)).toFixed(1)} 0)`);
    },
  };
}

/** Bar of a load, such as a torque. */
export function loadBar(): LoadBar {
  const fill = svg('rect', { class: 'actual', y: '12', height: '5', x: '50', width: '0' });
  const element = svg(
    'svg',
    { class: 'rate-bar', viewBox: '-4 0 108 20', preserveAspectRatio: 'none', 'aria-hidden': 'true' },
    svg('rect', { class: 'track', x: '4', y: '12', width: '92', height: '5' }),
    fill,
    svg('path', { class: 'tick', d: 'M50 9 V19' }),
  );
  return {
    element,
    set(actual) {
      const at = HALF * clamp(actual);
      setAttribute(fill, 'x', (at < 0 ? 50 + at : 50).toFixed(1));
      setAttribute(fill, 'width', Math.abs(at).toFixed(1));
    },
  };
}

/** The time axis over lanes and strips. */

import { el } from '../panel/parts/dom';
import { minutes } from './quantity';
import { lengthOf, partOf, type Span } from './span';

/** Possible distances between two marks [s]. */
const STEPS = [0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14_400];
const MOST_MARKS = 10;

/** Least distance of a labelled mark from the end of the axis, as a fraction of the axis. */
const ROOM = 0.02;

function stepOf(length: number): number {
  return STEPS.find((each) => length / each <= MOST_MARKS) ?? length / MOST_MARKS;
}

/** Returns the times of the marks [s]. There are none before zero, the start of a run. */
export function marks(span: Span): number[] {
  const step = stepOf(lengthOf(span));
  const first = Math.ceil(Math.max(0, span.from) / step);
  const last = Math.floor((span.to - ROOM * lengthOf(span)) / step);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => (first + i) * step).slice(
    0,
    MOST_MARKS,
  );
}

/** Returns the labels of the marks. */
export function labels(span: Span): readonly HTMLElement[] {
  const decimals = stepOf(lengthOf(span)) < 1 ? 1 : 0;
  return marks(span).map((time) => {
    const part = partOf(span, time);
    const place = `left: ${(part * 100).toFixed(3)}%`;
    return el(
      'span',
      part < ROOM ? { class: 'first', style: place } : { style: place },
      minutes(time, decimals),
    );
  });
}

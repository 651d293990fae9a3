/** The time axis over lanes and strips. */

import { el } from '../panel/parts/dom';
import { minutes } from './quantity';
import { lengthOf, partOf, type Span } from './span';

/** Possible distances between marks [s]. */
const STEPS = [0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14_400];
const MOST_MARKS = 10;

/** Least distance of a labelled mark from the end, as a part of the axis. */
const ROOM = 0.02;

function stepOf(length: number): number {
  return STEPS.find((each) => length / each <= MOST_MARKS) ?? length / MOST_MARKS;
}

/** Times of the axis' marks [s]; a run begins at zero. */
export function marks(span: Span): number[] {
  const step = stepOf(lengthOf(span));
  const first = Math.ceil(Math.max(0, span.from) / step);
  const last = Math.floor((span.to - ROOM * lengthOf(span)) / step);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => (first + i) * step).slice(
    0,
    MOST_MARKS,
  );
}

/** The marks' labels. */
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

/** The time axis over lanes and strips. */

import { el } from '../panel/dom';
import { minutes } from './quantity';

/** Distances between marks [s]. */
const STEPS = [1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14_400];
const MOST_MARKS = 10;

/** A mark nearer to the end than this part of the axis has no room for its time. */
const ROOM = 0.02;

/** Times of the axis' marks [s]. */
export function marks(duration: number): number[] {
  const step = STEPS.find((each) => duration / each <= MOST_MARKS) ?? duration / MOST_MARKS;
  return Array.from({ length: Math.floor((duration * (1 - ROOM)) / step) + 1 }, (_, i) => i * step);
}

export function axis(duration: number): HTMLElement {
  const labels = marks(duration).map((time) =>
    el('span', { style: `left: ${((time / duration) * 100).toFixed(3)}%` }, minutes(time)),
  );
  return el('div', { class: 'axis row' }, el('div', { class: 'plot' }, ...labels));
}

/** TEST: all digits on the desk become eights, as on displays with all segments lit. */

import { setText } from '../parts/dom';

const FIGURES = [
  '.resolution td:not(.of-limit)',
  '.joints .angle',
  '.distance .value',
  '.gap-value',
  '.spacing b',
  '.triple .value',
  '.route dd',
  '.met b',
  '.lag b',
].join();

/** Replaces the numbers by eights. The groups write their numbers again at the next update. */
export function lightSegments(): void {
  for (const figure of document.querySelectorAll(FIGURES)) setText(figure, segments(figure.textContent));
}

/** Returns `±888.8` for `−12.5`: both strokes of the sign, and always three digits before the tenths. */
export function segments(text: string): string {
  return text
    .replace(/\d/g, '8')
    .replace(/[+−]/, '±')
    .replace(/(^|±)8{1,2}\.8$/, '$1888.8');
}

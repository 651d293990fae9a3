/** Positions of the parts in the document. */

import { el, setClass } from '../panel/parts/dom';
import type { Parts } from './parts';
import { TOO_NARROW_WORDS } from './room';

/** Fills the page. The order in the document is also the order of the focus: monitors, spine, desk, rail. */
export function place(root: HTMLElement, parts: Parts): void {
  const { pictures, spine, groups, task, rail } = parts;
  const [first, second] = pictures.monitors.both;
  setClass(root, 'all-cameras', false); // the station of the previous scenario may have set it
  root.replaceChildren(
    task.line.element,
    pictures.canvas,
    el('main', { class: 'monitors' }, first.element, second.element, spine.element),
    pictures.matrix.element,
    el('section', { class: 'desk', 'aria-label': 'Desk' }, ...groups.elements, task.card.element),
    pictures.matrix.strip,
    rail.element,
    el('p', { class: 'too-narrow', role: 'status' }, TOO_NARROW_WORDS),
    parts.touch.element,
    parts.swap.element,
    parts.handOver.question,
    parts.scenarios.question,
    parts.pairNotice.element,
    parts.keys.element,
    parts.controlPage.element,
    parts.sheet.element,
  );
}

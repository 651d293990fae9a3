/** Positions of the parts in the document. */

import { el, setClass } from '../panel/parts/dom';
import type { Parts } from './parts';
import { TOO_NARROW_WORDS } from './room';

/** Fills the page. The order in the document is also the order of the focus: monitors, spine, desk, rail. */
export function place(root: HTMLElement, parts: Parts): void {
  const { pictures, spine, groups, task, rail } = parts;
  const [first, second] = pictures.monitors.both;
  const attributes = { class: 'desk', id: 'desk', 'aria-label': 'Desk', tabindex: '-1' };
  const desk = el('section', attributes, ...groups.elements, task.card.element);
  setClass(root, 'all-cameras', false); // the station of the previous scenario may have set it
  root.replaceChildren(
    skipLink(desk),
    task.line.element,
    task.said,
    pictures.canvas,
    el('main', { class: 'monitors' }, first.element, second.element, spine.element),
    parts.readiness.element,
    parts.opening.element,
    pictures.matrix.element,
    desk,
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
    parts.console.element,
    parts.sheet.element,
  );
}

/** Link that is visible while it has the focus. It moves the focus to the desk, past the keys of monitors and lamps. */
function skipLink(desk: HTMLElement): HTMLElement {
  const link = el('a', { class: 'skip', href: '#desk' }, 'Skip to the desk');
  link.addEventListener('click', (event) => {
    event.preventDefault(); // the page's address stays the same
    desk.focus();
  });
  return link;
}

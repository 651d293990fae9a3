/** Fills the page with one sentence, if there is no run or recording to show. */

import { el } from '../panel/parts/dom';

export function notice(root: HTMLElement, sentence: string): void {
  root.replaceChildren(
    el('main', { class: 'notice', role: 'alert' }, el('h1', {}, 'Aftdeck'), el('p', {}, sentence)),
  );
}

/** A full page of one sentence, for what leaves nothing to fly or to play. */

import { el } from '../panel/parts/dom';

export function notice(root: HTMLElement, sentence: string): void {
  root.replaceChildren(
    el('main', { class: 'notice', role: 'alert' }, el('h1', {}, 'Aftdeck'), el('p', {}, sentence)),
  );
}

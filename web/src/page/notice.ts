/** Fills the page with one sentence, if there is no run or recording to show, or if the page cannot start. */

import { el } from '../panel/parts/dom';

export function notice(root: HTMLElement, sentence: string): void {
  root.replaceChildren(
    el('main', { class: 'notice', role: 'alert' }, el('h1', {}, 'Aftdeck'), el('p', {}, sentence)),
  );
}

/** Returns the text of an error without its full stop. */
export function sentenceOf(error: unknown): string {
  return (error instanceof Error ? error.message : String(error)).replace(/\.$/, '');
}

/** Calls `start`; if it throws, fills the page with the reason and what to do. */
export function startOrNotice(root: HTMLElement, start: () => void): void {
  try {
    start();
  } catch (error) {
    console.error(error);
    const why = sentenceOf(error);
    notice(
      root,
      `The page cannot start: ${why}. Close other pages that draw with WebGL, and reload this page.`,
    );
  }
}

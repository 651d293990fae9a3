/** Outlines the elements to which a lamp refers. */

import type { Concern } from './lamps';

const OUTLINE_MS = 2000;

/** Outlines the elements of a concern for 2 s, or the group of the concern if the page has no such elements. */
export function outline({ elements, group }: Concern): void {
  const found = [...document.querySelectorAll(elements)];
  for (const element of found.length > 0 ? found : document.querySelectorAll(`.group${group}`)) {
    element.classList.add('concerned');
    setTimeout(() => element.classList.remove('concerned'), OUTLINE_MS);
  }
}

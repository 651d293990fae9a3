/** A list that opens below its key. It closes at a click outside, or when the focus leaves it. */

import { button, el } from './dom';

export interface DropDown {
  readonly element: HTMLElement;
  readonly key: HTMLButtonElement;
  readonly isOpen: boolean;
  open(on: boolean): void;
}

export function dropDown(name: string, title: string, list: HTMLElement): DropDown {
  list.hidden = true;
  const key = button({ 'aria-expanded': 'false', title }, [name], () => open(list.hidden === true));
  const open = (on: boolean) => {
    list.hidden = !on;
    key.setAttribute('aria-expanded', String(on));
  };
  const element = el('div', { class: 'drop-down' }, key, list);
  element.addEventListener('focusout', ({ relatedTarget }) => {
    if (relatedTarget instanceof Node && !element.contains(relatedTarget)) open(false);
  });
  return {
    element,
    key,
    get isOpen() {
      return !list.hidden;
    },
    open,
  };
}

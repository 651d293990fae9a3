/** The report's INITIALISE: start points of the problem, in a list under its key. */

import type { ProblemPart } from '../../link/protocol';
import { button, el } from '../parts/dom';
import { dropDown } from '../parts/drop-down';
import type { Desk } from '../parts/part';

const ABOUT: Readonly<Record<ProblemPart, string>> = {
  'full problem': 'From the first instant of the problem',
  acquisition: 'Mode 1: the end effector over the payload',
  extraction: 'Mode 2: the payload held, still in its place',
  manoeuvring: 'Mode 3: the payload held, clear of the bay',
};

export interface Initialise {
  readonly element: HTMLElement;
  close(): void;
}

export function initialise({ welcome, send }: Desk): Initialise {
  const parts = welcome.work.parts.map((part) =>
    button({ title: ABOUT[part] }, [part], () => {
      send({ type: 'initialise', part });
      drop.open(false);
    }),
  );
  const list = el('div', { class: 'choices', role: 'group', 'aria-label': 'Part of the problem' }, ...parts);
  const drop = dropDown('Initialise', 'Restart at a part of the problem', list);
  drop.element.hidden = parts.length === 0;
  return { element: drop.element, close: () => drop.open(false) };
}

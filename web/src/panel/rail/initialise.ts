/** INITIALISE of RMS-VS: a key, and below the key a list of the task phases at which the run can start. */

import type { ProblemPart } from '../../link/protocol';
import { button, el } from '../parts/dom';
import { dropDown } from '../parts/drop-down';
import type { Desk } from '../parts/part';

const ABOUT: Readonly<Record<ProblemPart, string>> = {
  'full problem': 'Start at the beginning of the full problem',
  acquisition: 'Start at task phase 1, with the end effector over the payload',
  extraction: 'Start at task phase 2, with the payload captured in its berth',
  manoeuvring: 'Start at task phase 3, with the payload captured and clear of the bay',
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
  const list = el('div', { class: 'choices', role: 'group', 'aria-label': 'Task phase' }, ...parts);
  const drop = dropDown('Initialise', 'Restart at a task phase', list);
  drop.element.hidden = parts.length === 0;
  return { element: drop.element, close: () => drop.open(false) };
}

/** Hand-over of control between pages: an observer asks for control, the operator gives or keeps it. */

import type { Role } from '../../link/protocol';
import type { Command } from '../../link/socket';
import { button, el, setText } from '../parts/dom';
import { called, calledFirst } from './operator-name';

/** Time for which both names are displayed after a hand-over [ms]. */
const SEEN_MS = 1000;

export interface HandOver {
  /** The question to the operator. */
  readonly question: HTMLElement;
  /** The observer's button that asks for control. */
  readonly ask: HTMLButtonElement;
  /** Names of the operator and the observers. */
  words(role: Role, now: number): string;
}

export function handOver(send: (command: Command) => void): HandOver {
  const asked = el('p', { role: 'alert' });
  const question = el(
    'section',
    { class: 'swap hand-over', 'aria-label': 'Hand-over', hidden: '' },
    asked,
    button({ title: 'Give control to the other page' }, ['Give'], () => send({ type: 'give_sticks' })),
    button({ title: 'Keep control' }, ['Keep'], () => send({ type: 'keep_sticks' })),
  );
  const ask = button({ title: 'Ask the page in control to hand over', hidden: '' }, ['Ask'], () =>
    send({ type: 'ask_sticks' }),
  );
  let before = { flier: 0, first: '' };
  let given = { from: '', at: Number.NEGATIVE_INFINITY };
  return {
    question,
    ask,
    words(role, now) {
      const { flying, may_fly, flier, number, asking } = role;
      if (before.flier !== 0 && flier !== 0 && flier !== before.flier)
        given = { from: before.first, at: now };
      before = { flier, first: calledFirst(role, flier) };
      if (question.hidden === (flying && asking !== 0)) question.hidden = !question.hidden;
      setText(asked, asking === 0 ? '' : `${calledFirst(role, asking)} asks for the sticks.`);
      const asks = !flying && may_fly && number !== 0; // a secondary or narrow window has number 0
      if (ask.hidden === asks) ask.hidden = !asks;
      ask.disabled = asking !== 0;
      setText(ask, asking === number ? 'Asked' : 'Ask for the sticks');
      if (now - given.at < SEEN_MS) return `${given.from} ▸ ${called(role, flier)}`;
      if (!flying) return flier === 0 ? 'Observing · unattended' : `Observing · ${called(role, flier)} flies`;
      const observers = observersOf(role);
      return observers === '' ? 'You fly' : `You fly · ${observers}`;
    },
  };
}

/** Returns a text about the observers: the name of a single observer, or the number of observers. */
function observersOf({ watchers, number, names }: Role): string {
  if (watchers === 0) return '';
  const other = names.find((each) => each.number !== number);
  return watchers === 1 ? `${other?.name ?? 1} observes` : `${watchers} observe`;
}

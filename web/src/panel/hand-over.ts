/** The sticks go from one page to another: who watches asks, who flies gives or keeps. */

import type { Role } from '../protocol';
import type { Command } from '../socket';
import { button, el, setText } from './dom';

/** What the other is called is seen beside one's own name this long [ms]. */
const SEEN_MS = 1000;

export interface HandOver {
  /** Asks: shown to who flies. */
  readonly question: HTMLElement;
  /** The key of who watches. */
  readonly ask: HTMLButtonElement;
  /** Who flies, and who watches. */
  words(role: Role, now: number): string;
}

export function handOver(send: (command: Command) => void): HandOver {
  const asked = el('p', { role: 'alert' });
  const question = el(
    'section',
    { class: 'swap hand-over', 'aria-label': 'Hand-over', hidden: '' },
    asked,
    button({ title: 'The other page flies from now on' }, ['Give'], () => send({ type: 'give_sticks' })),
    button({ title: 'You go on flying' }, ['Keep'], () => send({ type: 'keep_sticks' })),
  );
  const ask = button({ title: 'Asks the page that flies to give you its sticks', hidden: '' }, ['Ask'], () =>
    send({ type: 'ask_sticks' }),
  );
  let before = 0;
  let given = { from: 0, at: Number.NEGATIVE_INFINITY };
  return {
    question,
    ask,
    words(role, now) {
      const { flying, flier, number, asking, watchers } = role;
      if (before !== 0 && flier !== before) given = { from: before, at: now };
      before = flier;
      if (question.hidden === (flying && asking !== 0)) question.hidden = !question.hidden;
      setText(asked, asking === 0 ? '' : `Page ${asking} asks for the sticks.`);
      const asks = !flying && number !== 0; // a page without hands asks for none
      if (ask.hidden === asks) ask.hidden = !asks;
      ask.disabled = asking !== 0;
      setText(ask, asking === number ? 'Asked' : 'Ask for the sticks');
      if (now - given.at < SEEN_MS) return `Page ${given.from} ▸ page ${flier}`;
      if (!flying) return flier === 0 ? 'You watch · nobody flies' : `You watch · page ${flier} flies`;
      return watchers === 0 ? 'You fly' : `You fly · ${watchers} watch${watchers === 1 ? 'es' : ''}`;
    },
  };
}

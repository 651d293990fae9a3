/** Who flies and who watches, in the rail; under it a field for what the person at this page is called. */

import type { Role } from '../../link/protocol';
import type { Command } from '../../link/socket';
import type { Keeper } from '../../page/local-storage';
import { button, el, setAttribute, setClass, setText } from '../parts/dom';
import { dropDown } from '../parts/drop-down';

const KEPT = 'aftdeck.name';
/** As the station takes it [characters]. */
const MOST = 24;
/** `You watch · page 1 flies`: so much there is always room for [characters]. */
const USUAL = 24;
const OFFER = 'press to say what you are called';

export interface Naming {
  readonly element: HTMLElement;
  /** Says who flies; pressed, it opens the field. */
  readonly key: HTMLButtonElement;
  say(text: string): void;
  /** Take the station's list; a page in control without a name sends the stored name. */
  set(role: Role): void;
  /** Whether what the station refused is the name that was typed. */
  refuse(number: number, text: string): boolean;
  close(): void;
}

/** `send` returns the command's number. */
export function naming(keeper: Keeper, send: (command: Command) => number): Naming {
  let asked: { readonly number: number; readonly name: string } | null = null;
  let now = '';
  /** What the person here is called; another page of the browser may keep another. */
  let mine = keeper.getItem(KEPT) ?? '';
  const field = el('input', {
    type: 'text',
    inputmode: 'text',
    maxlength: String(MOST),
    autocomplete: 'off',
    spellcheck: 'false',
  });
  const wrong = el('p', { class: 'wrong', role: 'alert' });
  const list = el(
    'div',
    { class: 'choices naming', role: 'group', 'aria-label': 'Your name' },
    el('label', {}, 'Your name', field),
    button({}, ['Use this name'], () => ask()),
    wrong,
    el('p', {}, ABOUT),
  );
  const drop = dropDown('', '', list);
  drop.key.classList.add('who');
  drop.key.setAttribute('aria-live', 'polite');
  drop.key.addEventListener('click', () => {
    setText(wrong, '');
    field.value = now;
    if (!drop.isOpen) return;
    field.focus();
    field.select();
  });
  field.addEventListener('keydown', ({ key }) => {
    if (key === 'Enter') ask();
  });
  const ask = () => {
    setText(wrong, '');
    asked = { name: field.value, number: send({ type: 'set_name', name: field.value }) };
    if (asked.name === now) taken();
  };
  /** The station has the name: the browser keeps it. */
  const taken = () => {
    asked = null;
    mine = now;
    keeper.setItem(KEPT, now);
    close();
  };
  const close = () => {
    field.blur(); // its letters fly again
    drop.open(false);
  };
  return {
    element: drop.element,
    key: drop.key,
    say(text) {
      setText(drop.key, text);
      setClass(drop.element, 'long', text.length > USUAL);
      setAttribute(drop.key, 'title', `${text}: ${OFFER}`);
    },
    set({ name, number }) {
      now = name;
      if (asked?.name === name) taken();
      drop.key.disabled = number === 0; // a page without a seat has no name
      if (drop.key.disabled) close();
      else if (name === '' && mine !== '') send({ type: 'set_name', name: mine });
    },
    refuse(number, text) {
      if (number !== asked?.number) return false;
      asked = null;
      setText(wrong, text);
      return true;
    },
    close,
  };
}

const ABOUT =
  'Other pages and the log of hand-overs display this name; a recording contains the log. ' +
  'Without a name you have a number. This browser stores the name.';

/** Names of operator and observers in the rail, and below them a field for the user's name. */

import type { Role } from '../../link/protocol';
import type { Command } from '../../link/socket';
import type { Keeper } from '../../page/local-storage';
import { button, el, setAttribute, setClass, setText } from '../parts/dom';
import { dropDown } from '../parts/drop-down';

const KEPT = 'aftdeck.name';
/** Greatest length of a name at the station [characters]. */
const MOST = 24;
/** Greatest length for which the rail always has room: the length of `Observing · page 1 flies` [characters]. */
const USUAL = 24;
const OFFER = 'press to enter your name';

export interface Naming {
  readonly element: HTMLElement;
  /** Button that shows the names of operator and observers, and opens the field. */
  readonly key: HTMLButtonElement;
  say(text: string): void;
  /** Called for each `Role` message. If this page has no name at the station, sends the stored name. */
  set(role: Role): void;
  /**
   * Called for a rejected command. If this command sent the name that the user has entered, shows `text`, the reason
   * for the rejection, and returns true.
   */
  refuse(number: number, text: string): boolean;
  close(): void;
}

/** `send` returns the command's number. */
export function naming(keeper: Keeper, send: (command: Command) => number): Naming {
  let asked: { readonly number: number; readonly name: string } | null = null;
  let now = '';
  /** The user's stored name, read once: another page of the browser may store another name later. */
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
  /** Called when the station has accepted the name: stores it. */
  const taken = () => {
    asked = null;
    mine = now;
    keeper.setItem(KEPT, now);
    close();
  };
  const close = () => {
    field.blur(); // letters control the arm again
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
      drop.key.disabled = number === 0; // a page that can only observe has number 0 and no name
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

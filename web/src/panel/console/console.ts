/** The console, the report's typewriter: prints values of the scenario, and changes them while the run lasts. */

import type { Completed, Typed } from '../../link/protocol';
import type { Command } from '../../link/socket';
import { button, el, setText } from '../parts/dom';
import { common, completed, History } from './history';

/** Greatest number of lines that stay. */
const MOST_LINES = 400;

export class Console {
  private readonly output = el('div', { class: 'lines', role: 'log', 'aria-label': 'Answers' });
  private readonly choices = el('p', { class: 'words', 'aria-live': 'polite' });
  private readonly input = el('input', {
    type: 'text',
    'aria-label': 'Line for the console',
    placeholder: 'print KEY, set KEY = VALUE, help; Tab completes',
    spellcheck: 'false',
    autocomplete: 'off',
    autocapitalize: 'off',
  });
  private readonly history = new History();
  /** Number of the last request for completions. */
  private asked = -1;
  readonly element = el(
    'dialog',
    { class: 'console', 'aria-label': 'Console' },
    el(
      'header',
      {},
      el('h2', {}, 'Console'),
      el('span', { class: 'about' }, 'values of scenario, arm and worksite'),
      button({ class: 'done' }, ['Close'], () => this.toggle()),
    ),
    this.output,
    el('form', {}, el('span', { 'aria-hidden': 'true' }, '›'), this.input),
    this.choices,
  );

  /** `transmit` sends a command and returns its number. */
  constructor(private readonly transmit: (command: Command) => number) {
    this.element.querySelector('form')?.addEventListener('submit', (event) => {
      event.preventDefault();
      this.enter();
    });
    this.input.addEventListener('keydown', (event) => this.key(event));
    this.input.addEventListener('input', () => setText(this.choices, ''));
  }

  toggle(): void {
    if (this.element.open) this.element.close();
    else {
      this.element.show();
      this.input.focus();
    }
  }

  close(): void {
    this.element.close();
  }

  /** Shows the answer to a line. */
  typed({ lines, refused }: Typed): void {
    for (const line of lines) this.say(line, refused ? 'refused' : 'answer');
  }

  /** Completes the last word as far as all possible words are equal, and shows these words. */
  complete({ seq, words }: Completed): void {
    if (seq !== this.asked || words.length === 0) return;
    this.input.value = completed(this.input.value, common(words));
    setText(this.choices, words.length > 1 ? words.join('   ') : '');
  }

  private key(event: KeyboardEvent): void {
    if (event.key === 'Tab' && !event.shiftKey && this.input.value !== '') {
      event.preventDefault();
      this.asked = this.transmit({ type: 'complete_line', line: this.input.value });
    } else if (event.key === 'ArrowUp' || event.key === 'ArrowDown') {
      event.preventDefault();
      this.input.value = this.history.step(event.key === 'ArrowUp' ? -1 : 1);
    } else if (event.key === 'Escape') {
      event.preventDefault();
      this.close();
    }
  }

  private enter(): void {
    const line = this.input.value.trim();
    if (line === '') return;
    this.history.add(line);
    this.say(`› ${line}`, 'typed');
    this.input.value = '';
    setText(this.choices, '');
    this.transmit({ type: 'type_line', line });
  }

  private say(text: string, kind: 'typed' | 'answer' | 'refused'): void {
    this.output.append(el('p', { class: kind }, text));
    while (this.output.childElementCount > MOST_LINES) this.output.firstElementChild?.remove();
    this.output.scrollTop = this.output.scrollHeight;
  }
}

/**
 * The log, newest line first: three lines, or on demand all entries in full. After a press of a lamp, only the lines
 * that belong to the lamp are displayed.
 */

import type { Event as LogEvent } from '../../link/protocol';
import { clock } from '../../words/format';
import { button, el, group, setAbout, setText } from '../parts/dom';

const LINES = 3;
/** Number of stored entries. Older entries are deleted. */
const KEPT = 200;

export class EventsGroup {
  readonly element: HTMLElement;
  private readonly list = el('ol', { class: 'log' });
  /** All entries in full. The open list covers read-outs, but no keys. */
  private readonly whole = el('ol', { class: 'log wrapped', 'aria-label': 'Events in full', tabindex: '0' });
  private readonly more: HTMLButtonElement;
  private readonly all: HTMLButtonElement;
  private events: readonly LogEvent[] = [];
  private open = false;
  private keptTo: { readonly name: string; readonly kinds: readonly string[] } | null = null;

  /** `hints` are displayed below the oldest line. */
  constructor(private readonly hints: readonly string[]) {
    this.more = button({ class: 'more', 'aria-expanded': 'false' }, ['more'], () => this.toggle());
    this.all = button({ class: 'all', hidden: '' }, ['show all'], () => this.keepTo('', []));
    this.element = group('events', 'Events', this.list, this.whole);
    this.element.querySelector('h2')?.append(this.all, this.more);
    this.draw();
  }

  /** Adds lines, oldest first. */
  add(events: readonly LogEvent[]): void {
    this.events = [...events].reverse().concat(this.events).slice(0, KEPT);
    // A new line that the filter would hide ends the filter.
    if (events.some((event) => !this.shows(event))) this.keptTo = null;
    this.draw();
  }

  clear(): void {
    this.events = [];
    this.keptTo = null;
    this.draw();
  }

  /**
   * Shows only lines of these kinds, for the lamp `name`. Shows all lines if `kinds` is empty, or if the lines of this
   * lamp are already displayed.
   */
  keepTo(name: string, kinds: readonly string[]): void {
    this.keptTo = kinds.length === 0 || this.keptTo?.name === name ? null : { name, kinds };
    this.draw();
  }

  private shows({ kind }: LogEvent): boolean {
    return this.keptTo === null || this.keptTo.kinds.includes(kind);
  }

  private get bottom(): number {
    return this.list.offsetTop + this.list.offsetHeight + 1;
  }

  private toggle(): void {
    this.open = !this.open;
    this.element.classList.toggle('open', this.open);
    this.more.setAttribute('aria-expanded', String(this.open));
    setText(this.more, this.open ? 'less' : 'more');
    this.draw();
  }

  /** Writes the lines that fit; called again if the size of the window changes. */
  draw(): void {
    const { keptTo } = this;
    setAbout(this.element, keptTo ? `${keptTo.name} only` : '');
    this.all.hidden = keptTo === null;
    const under = keptTo ? [`No older lines about ${keptTo.name}.`] : this.hints;
    const events = this.events.filter((event) => this.shows(event));
    const hints = under.map(hintLine);
    const lines = [
      ...events.slice(0, LINES).map((event) => logLine(event, firstReason(event.text))),
      ...hints,
    ].slice(0, LINES);
    // Hints, and the newest caution or warning or else the newest line, may take all lines down to the last.
    const important = events.slice(0, LINES - 1).findIndex(({ level }) => level !== 'info');
    const place = Math.max(0, important);
    for (const line of lines.filter(({ classList }, i) => i === place || classList.contains('hint'))) {
      line.classList.add('whole');
      line.style.setProperty('--lines', String(LINES - place));
    }
    this.list.replaceChildren(...lines);
    // Lines for which the wrapped lines leave no room become invisible, but screen readers still read them.
    const over = lines.filter((line) => line.offsetTop + line.offsetHeight > this.bottom);
    for (const line of over) line.classList.add('unseen');
    this.whole.hidden = !this.open;
    this.whole.replaceChildren(
      ...(this.open ? [...events.map((event) => logLine(event)), ...under.map(hintLine)] : []),
    );
  }
}

/** Returns a log's text with only the first of its reasons, and the number of the others. */
function firstReason(text: string): string {
  const [first = '', ...others] = text.split('; ');
  return others.length === 0 ? first : `${first} (+${others.length})`;
}

/** Returns a line of a log that displays `shown`. */
export function logLine({ time_s, kind, level, text }: LogEvent, shown = text): HTMLElement {
  return el(
    'li',
    { class: level, 'data-kind': kind },
    el('time', {}, clock(time_s)),
    el('i', { class: 'sign', role: 'img', 'aria-label': level }),
    el('span', { title: text }, shown),
  );
}

/** Returns a hint below the lines of a log. */
export function hintLine(text: string): HTMLElement {
  return el('li', { class: 'hint' }, el('span', { title: text }, text));
}

/** Values that summarise the run, and its log up to the playhead, at the right of the monitors. */

import type { PlaybackIndex } from '../link/protocol';
import { hintLine, logLine } from '../panel/desk/events';
import { button, el, group, setClass, setText } from '../panel/parts/dom';
import type { Units } from '../words/units';
import { figure } from './quantity';

/** Height of a line [rem], equal to the height of `.log li`. */
const LINE = 1.28;
const HINTS = [
  'Space: play, pause. Home, End: start, end.',
  'Left, right: one second; with Shift, one frame.',
  'Up, down: speed. [ ]: previous, next event.',
  '1–9, 0 , . cameras · X monitor · Z split · C all',
  'A cameras as flown · D desk · F plane · B bending',
  '+ − time axis',
];

export class RunColumn {
  readonly element: HTMLElement;
  private readonly log = el('ol', { class: 'log' });
  private readonly figures;
  private shown = '';

  constructor(private readonly index: PlaybackIndex) {
    this.figures = index.measures.map((measure) => {
      const value = el('td');
      const row = el('tr', { title: measure.about }, el('th', { scope: 'row' }, measure.name), value);
      setClass(value, measure.level, measure.level !== 'info');
      return { measure, row, value };
    });
    const table = el('table', {}, el('tbody', {}, ...this.figures.map(({ row }) => row)));
    const [figures, log] = [group('measures', 'This run', table), group('run-log', 'Log', this.log)];
    this.element = el('aside', { class: 'run' }, figures, log);
    // If the window is too low for figures and log, only one of them is visible.
    const turn = (from: HTMLElement, to: HTMLElement, name: string, showsLog: boolean) => {
      const key = button({ class: 'more' }, [name], () => {
        setClass(this.element, 'shows-log', showsLog);
        to.querySelector('button')?.focus();
      });
      from.querySelector('h2')?.append(key);
    };
    turn(figures, log, 'Log', true);
    turn(log, figures, 'Figures', false);
  }

  /** `past`: number of events up to the playhead. */
  show(past: number, units: Units): void {
    for (const { measure, value } of this.figures) setText(value, figure(measure, units));
    const rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
    const room = Math.floor(this.log.clientHeight / (LINE * rem));
    const asked = `${past} ${room}`;
    if (asked === this.shown) return;
    this.shown = asked;
    const lines = this.index.events.slice(Math.max(0, past - room), past).reverse();
    const hints = HINTS.slice(0, Math.max(0, room - lines.length));
    this.log.replaceChildren(...lines.map((event) => logLine(event)), ...hints.map(hintLine));
  }
}

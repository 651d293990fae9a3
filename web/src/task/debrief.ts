/** The result of a run on the card: grade, figures, faults, best run so far, and the ways on. */

import type { Debrief, Recorded, Welcome } from '../link/protocol';
import { keeper } from '../page/local-storage';
import { button, el, setAttribute, setClass, setText } from '../panel/parts/dom';
import { figure } from '../replay/quantity';
import { durationText } from '../words/format';
import type { Units } from '../words/units';
import { type Best, bestOf, keepBest } from './best';

export interface DebriefListener {
  again(): void;
  /** Loads the next scenario. */
  next(scenario: string): void;
}

const GRADES =
  'A: no faults. Contacts that inhibited the arm, clearance warnings and hard stops each lower the grade by one.';
/** Name of the figure with the time of the run. */
const TIME = 'Run time';

export class DebriefView {
  readonly element: HTMLElement;
  readonly ways: HTMLElement;
  private readonly grade = el('b', { class: 'grade' });
  private readonly faults = el('p', { class: 'faults' });
  private readonly best = el('p', { class: 'best' });
  private readonly rows = el('dl');
  private readonly replay = el('a', { class: 'key', hidden: '' }, 'Watch replay');
  private shown: Debrief | null = null;

  constructor(
    private readonly welcome: Pick<Welcome, 'scenario' | 'next'>,
    listener: DebriefListener,
  ) {
    const { next } = welcome;
    this.element = el(
      'div',
      { class: 'debrief' },
      el('div', { class: 'result' }, el('span', {}, 'Grade '), this.grade, this.faults, this.best),
      this.rows,
    );
    this.ways = el(
      'div',
      { class: 'on' },
      button({}, ['Again'], () => listener.again()),
      this.replay,
      ...(next ? [button({}, ['Next scenario'], () => listener.next(next))] : []),
    );
    this.element.hidden = this.ways.hidden = true;
  }

  /** `recorded`: whether the run is recorded; `flying`: whether this page is in control. */
  set(debrief: Debrief | null, units: Units, recorded: boolean, flying: boolean): void {
    this.element.hidden = this.ways.hidden = debrief === null;
    if (!debrief) {
      this.shown = null;
      return;
    }
    if (JSON.stringify(debrief) !== JSON.stringify(this.shown)) this.begin(debrief, recorded, flying);
    this.rows.replaceChildren(
      ...debrief.figures.map((each) =>
        el('div', { title: each.about }, el('dt', {}, each.name), el('dd', {}, figure(each, units))),
      ),
    );
  }

  private begin(debrief: Debrief, recorded: boolean, flying: boolean): void {
    const { scenario } = this.welcome;
    this.shown = debrief;
    const time = debrief.figures.find(({ name }) => name === TIME)?.value ?? 0;
    const before = bestOf(keeper, scenario);
    const run = debrief.grade && flying ? { grade: debrief.grade, time } : null;
    const better = run !== null && keepBest(keeper, scenario, run);
    setText(this.grade, debrief.grade ?? '–');
    setClass(this.grade, 'good', debrief.grade === 'A');
    setText(this.faults, debrief.faults.join(', ') || 'No faults');
    setAttribute(this.faults, 'title', GRADES);
    setText(this.best, run || before ? bestWords(before, better) : '');
    this.replay.hidden = true;
    if (recorded) void this.findReplay();
  }

  private async findReplay(): Promise<void> {
    const answer = await fetch('recordings.json').catch(() => null);
    if (!answer?.ok) return;
    const all: readonly Recorded[] = await answer.json();
    const run = all.find(({ now }) => now);
    if (!run) return;
    this.replay.setAttribute('href', `replay/${encodeURIComponent(run.file)}/`);
    this.replay.hidden = false;
  }
}

/** Returns a sentence about the best run before this one. */
export function bestWords(before: Best | null, better: boolean): string {
  if (!before) return 'Your first run';
  const last = `${before.grade}, ${durationText(before.time)}`;
  return better ? `Your best run; before: ${last}` : `Your best run: ${last}`;
}

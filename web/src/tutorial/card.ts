/** The tutorial's card. It covers those controls of the desk that a beginner does not need. */

import type { InHand } from '../input/active-device';
import { button, el, setClass, setText } from '../panel/parts/dom';
import { padDrawing } from './pad';
import { isOver, type Progress } from './progress';
import { type Cap, STEPS } from './steps';
import { pieces } from './words';

/** Note under every step. */
const NOTE = 'You cannot damage anything here. {stop} stops all motion.';

export interface CardListener {
  back(): void;
  skip(): void;
  close(): void;
  /** Enters the tutorial's mode. */
  enterMode(): void;
}

export class Card {
  readonly element: HTMLElement;
  private readonly marks = STEPS.map(() => el('li'));
  private readonly count = el('span');
  private readonly title = el('h2', { 'aria-live': 'polite' });
  private readonly words = el('p', { class: 'words' });
  private readonly note = el('p', { class: 'note' });
  private readonly mode: HTMLElement;
  private readonly modeWords = el('span');
  private readonly next = el('p', { class: 'next' });
  private readonly caps = el('div', { class: 'caps' });
  private readonly drawing = padDrawing();
  private readonly back: HTMLButtonElement;
  private readonly skip: HTMLButtonElement;
  private lights: readonly { readonly use: string; readonly cap: HTMLElement }[] = [];
  private written = '';

  constructor(
    private readonly inHand: InHand,
    listener: CardListener,
  ) {
    this.back = button({}, ['Back'], () => listener.back());
    this.skip = button({}, ['Skip step'], () => listener.skip());
    this.mode = el(
      'p',
      { class: 'elsewhere' },
      this.modeWords,
      button({}, ['Enter END EFF'], () => listener.enterMode()),
    );
    this.element = el(
      'section',
      { class: 'tutorial', 'aria-label': 'Tutorial' },
      el('div', { class: 'steps' }, el('ol', { 'aria-hidden': 'true' }, ...this.marks), this.count),
      el('div', { class: 'told' }, this.title, this.words, this.mode, this.note),
      el('div', { class: 'flown-with' }, this.drawing.element, this.caps),
      el(
        'div',
        { class: 'ways' },
        this.next,
        this.back,
        this.skip,
        button({}, ['Close the guide'], () => listener.close()),
      ),
    );
  }

  /** `words`: text of the present step; `astray`: the entered mode if it is not the mode of the step, else empty. */
  set(progress: Progress, words: string, title: string, astray: string): void {
    const { at, skipped } = progress;
    const over = isOver(progress);
    this.marks.forEach((mark, i) => {
      setClass(mark, 'done', i < at && !skipped.has(i));
      setClass(mark, 'skipped', i < at && skipped.has(i));
      setClass(mark, 'present', i === at);
    });
    setText(this.count, over ? doneWords(skipped.size) : `${at + 1} of ${STEPS.length}`);
    setText(this.title, title);
    this.write(words, over);
    this.mode.hidden = over || astray === '';
    setText(this.modeWords, `The mode is ${astray}; this step needs END EFF.`);
    this.note.hidden = !this.mode.hidden;
    const following = STEPS[at + 1]?.title.toLowerCase() ?? '';
    setText(this.next, following && `Next: ${following}`);
    this.back.disabled = at === 0;
    this.skip.disabled = over;
  }

  /** Lights the caps of the controls that are held; called for each picture. */
  light(): void {
    const { device } = this.inHand;
    for (const { use, cap } of this.lights) setClass(cap, 'held', this.inHand.holds(use));
    const drawn = device?.kind.endsWith('pad') === true && this.lights.length > 0;
    setClass(this.element, 'by-pad', drawn);
    if (drawn && device) this.drawing.set(device, this.inHand.sources(this.lights.map(({ use }) => use)));
  }

  /** Draws the key caps of a step. */
  setCaps(caps: readonly Cap[]): void {
    const there = caps.filter(([use]) => this.inHand.name(use) !== '');
    const keys = this.inHand.device === null;
    setClass(this.element, 'by-keys', keys);
    this.lights = there.map(([use, does]) => ({
      use,
      cap: el('kbd', {}, el('b', {}, this.inHand.name(use)), el('small', {}, does)),
    }));
    this.caps.replaceChildren(...this.lights.map(({ cap }) => cap));
  }

  private write(words: string, over: boolean): void {
    const written = `${this.inHand.kinds.join()} ${words}`;
    if (written === this.written) return;
    this.written = written;
    this.words.replaceChildren(...this.nodes(words));
    this.note.replaceChildren(...(over ? [] : this.nodes(NOTE)));
  }

  private nodes(words: string): (Node | string)[] {
    return pieces(words).map(({ kind, text }) => {
      if (kind === 'text') return text;
      return kind === 'use' ? el('b', {}, this.inHand.name(text) || '–') : el('em', {}, text);
    });
  }
}

function doneWords(skipped: number): string {
  if (skipped === 0) return 'All six done';
  return skipped === STEPS.length ? 'All skipped' : `${STEPS.length - skipped} done, ${skipped} skipped`;
}

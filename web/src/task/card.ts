/** The card of the present step. It covers those groups of the desk that the step does not need. */

import type { InHand } from '../input/active-device';
import type { Debrief, UseInfo, Welcome } from '../link/protocol';
import { button, el, setClass, setText } from '../panel/parts/dom';
import type { Units } from '../words/units';
import { type DebriefListener, DebriefView } from './debrief';
import { padDrawing } from './pad';
import { goElement, type Left } from './to-go';
import { keyElement, MarkedText, type Piece } from './words';

export interface CardListener extends DebriefListener {
  back(): void;
  skip(): void;
  close(): void;
  /** Enters the mode that the step needs. */
  enterMode(): void;
}

/** What the card shows of the present step. */
export interface Shown {
  readonly at: number;
  readonly titles: readonly string[];
  /** Whether each step is complete. */
  readonly done: readonly boolean[];
  readonly title: string;
  readonly pieces: readonly Piece[];
  /** Mode that the step needs, if another one is entered; else empty. */
  readonly needs: string;
  /** The entered mode. */
  readonly mode: string;
}

export class Card {
  readonly element: HTMLElement;
  private readonly marks;
  private readonly count = el('span');
  private readonly title = el('h2');
  private readonly words: MarkedText;
  private readonly note: MarkedText;
  private readonly mode: HTMLElement;
  private readonly modeWords = el('span');
  private readonly enter: HTMLButtonElement;
  private readonly next = el('p', { class: 'next' });
  private readonly caps = el('div', { class: 'caps', role: 'list', 'aria-label': 'Controls of this step' });
  private readonly drawing = padDrawing();
  private readonly back: HTMLButtonElement;
  private readonly skip: HTMLButtonElement;
  private readonly go;
  private readonly debrief: DebriefView;
  private lights: readonly { readonly use: string; readonly cap: HTMLElement }[] = [];

  /** `noteWords`: text below the text of every step. */
  constructor(
    private readonly inHand: InHand,
    welcome: Pick<Welcome, 'steps' | 'scenario' | 'next' | 'joints'>,
    private readonly noteWords: readonly Piece[],
    listener: CardListener,
  ) {
    this.go = goElement(welcome.joints);
    this.marks = welcome.steps.map(() => el('li'));
    this.words = new MarkedText(el('p', { class: 'words' }), inHand);
    this.note = new MarkedText(el('p', { class: 'note' }), inHand);
    this.debrief = new DebriefView(welcome, listener);
    this.back = button({}, ['Back'], () => listener.back());
    this.skip = button({}, ['Skip step'], () => listener.skip());
    this.enter = button({}, [], () => listener.enterMode());
    this.mode = el('p', { class: 'elsewhere' }, this.modeWords, this.enter);
    this.element = el(
      'section',
      { class: 'task', 'aria-label': 'Guide' },
      el(
        'div',
        { class: 'steps' },
        el(
          'ol',
          { class: 'marks', 'aria-hidden': 'true', style: `--count: ${this.marks.length}` },
          ...this.marks,
        ),
        this.count,
        this.go.element,
      ),
      el(
        'div',
        { class: 'instruction' },
        this.title,
        this.words.element,
        this.mode,
        el('div', { class: 'room' }, this.note.element),
      ),
      el('div', { class: 'flown-with' }, this.drawing.element, this.caps, this.debrief.element),
      el(
        'div',
        { class: 'ways' },
        this.next,
        this.debrief.ways,
        this.back,
        this.skip,
        button({}, ['Close the guide'], () => listener.close()),
      ),
    );
  }

  set({ at, titles, done, title, pieces, needs, mode }: Shown): void {
    const over = at >= titles.length;
    this.marks.forEach((mark, i) => {
      setClass(mark, 'done', done[i] === true);
      setClass(mark, 'skipped', i < at && !done[i]);
      setClass(mark, 'present', i === at);
    });
    setText(this.count, countWords(at, done));
    setText(this.title, title);
    this.words.set(pieces);
    this.note.set(over ? [] : this.noteWords);
    this.mode.hidden = needs === '';
    const key = this.inHand.name('enter');
    const press = key === '' ? '' : ` Press ${key}:`;
    setText(this.modeWords, `The mode is ${mode}; this step needs ${needs}.${press}`);
    setText(this.enter, `Enter ${needs}`);
    this.note.element.hidden = !this.mode.hidden;
    const following = titles[at + 1] ?? '';
    setText(this.next, following && `Next: ${following}`);
    this.back.disabled = at === 0;
    this.skip.disabled = over;
  }

  setGo(left: Left, units: Units): void {
    this.go.set(left, units, this.inHand);
  }

  /** Shows the result of the run in place of the key caps; null if there is none. */
  setDebrief(debrief: Debrief | null, units: Units, recorded: boolean, flying: boolean): void {
    this.caps.hidden = debrief !== null;
    this.debrief.set(debrief, units, recorded, flying);
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
  setCaps(uses: readonly UseInfo[]): void {
    const there = uses.filter(({ use }) => this.inHand.name(use) !== '');
    const keys = this.inHand.device === null;
    setClass(this.element, 'by-keys', keys);
    setClass(this.caps, 'many', there.length > 6);
    setClass(this.caps, 'most', there.length > 8);
    this.lights = there.map(({ use, does }) => ({
      use,
      cap: el('kbd', { role: 'listitem' }, keyElement(this.inHand.name(use)), el('small', {}, does)),
    }));
    this.caps.replaceChildren(...this.lights.map(({ cap }) => cap));
  }
}

/** Returns the number of the present step, or of the completed steps when all are past. */
export function countWords(at: number, done: readonly boolean[]): string {
  const all = done.length;
  if (at < all) return `${at + 1} of ${all}`;
  const complete = done.filter((each) => each).length;
  return complete === all ? `All ${all} done` : `${complete} of ${all} done, ${all - complete} skipped`;
}

/** The present step of the task in one line below the rail, while the card is closed. */

import type { InHand } from '../input/active-device';
import type { Welcome } from '../link/protocol';
import { el, setAttribute, setText } from '../panel/parts/dom';
import type { Units } from '../words/units';
import { goElement, type Left } from './to-go';
import { MarkedText, type Piece } from './words';

export class Line {
  readonly element: HTMLElement;
  private readonly count = el('span', { class: 'count' });
  private readonly title = el('b', { class: 'title' });
  private readonly words: MarkedText;
  private readonly go;

  /** `key` is a button for what the user can do next. */
  constructor(
    private readonly inHand: InHand,
    { joints }: Pick<Welcome, 'joints'>,
    key: HTMLElement,
  ) {
    this.go = goElement(joints);
    this.words = new MarkedText(el('span', { class: 'words' }), inHand);
    this.element = el(
      'section',
      { class: 'task-line', 'aria-label': 'Task' },
      el('div', {}, this.count, el('p', {}, this.title, ' ', this.words.element)),
      el('div', { class: 'far' }, this.go.element, key),
    );
    // The pictures begin below this line, which is as high as its text.
    new ResizeObserver(() => {
      const { offsetHeight, parentElement } = this.element;
      parentElement?.style.setProperty(
        '--task-line',
        offsetHeight > 0 ? `calc(${offsetHeight}px + 0.3rem)` : '0rem',
      );
    }).observe(this.element);
  }

  set(count: string, title: string, words: readonly Piece[]): void {
    setText(this.count, count);
    setText(this.title, title);
    this.words.set(words);
    const { element } = this.words;
    setAttribute(element, 'title', element.textContent);
  }

  setGo(left: Left, units: Units): void {
    this.go.set(left, units, this.inHand);
  }
}

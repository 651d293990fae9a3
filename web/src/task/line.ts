/** The present step of the task in one line below the rail, while the card is closed. */

import type { InHand } from '../input/active-device';
import { revision } from '../input/store';
import type { ToGo } from '../link/protocol';
import { button, el, setAttribute, setText } from '../panel/parts/dom';
import type { Units } from '../words/units';
import { goElement } from './to-go';
import { nodes, type Piece } from './words';

export interface LineListener {
  open(): void;
}

const OPEN = 'Show this step with its controls';

export class Line {
  readonly element: HTMLElement;
  private readonly count = el('span', { class: 'count' });
  private readonly title = el('b', { class: 'title', 'aria-live': 'polite' });
  private readonly words = el('span', { class: 'words' });
  private readonly go = goElement();
  private written = '';

  /** `listener`: null if the scenario has no steps. */
  constructor(
    private readonly inHand: InHand,
    listener: LineListener | null,
  ) {
    this.element = el(
      'section',
      { class: 'task-line', 'aria-label': 'Task' },
      el('div', {}, this.count, el('p', {}, this.title, ' ', this.words)),
      el(
        'div',
        { class: 'far' },
        this.go.element,
        ...(listener ? [button({ title: OPEN }, ['Open the guide'], () => listener.open())] : []),
      ),
    );
  }

  set(count: string, title: string, words: readonly Piece[]): void {
    setText(this.count, count);
    setText(this.title, title);
    const written = `${this.inHand.kinds.join()} ${revision()} ${JSON.stringify(words)}`;
    if (written === this.written) return;
    this.written = written;
    this.words.replaceChildren(...nodes(words, this.inHand));
    setAttribute(this.words, 'title', this.words.textContent);
  }

  setGo(go: ToGo | null, units: Units): void {
    this.go.set(go, units, this.inHand);
  }
}

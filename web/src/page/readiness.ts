/** Says over the monitors what is not ready yet: the compilation of the laws, or that the run waits. */

import type { Readiness } from '../link/protocol';
import { el, setClass, setText } from '../panel/parts/dom';

const READY: Readiness = { type: 'readiness', waits_for: '', share: null, left_s: null, failure: '' };

/** Sentence about what is not ready; empty if all is. */
export function readinessText({ waits_for, share, left_s, failure }: Readiness): string {
  if (waits_for === 'page') return 'The run begins when the page in control has drawn its first pictures.';
  const left = left_s === null ? 'a minute or two' : `${left_s} s`;
  if (waits_for === 'laws')
    return `The run waits for compiled laws, ${left}: this step is too slow without them.`;
  if (share !== null) return `Compiling the laws: look-ahead in ${left}`;
  return failure && `No look-ahead: ${failure}`;
}

export class ReadinessNotice {
  private readonly text = el('span');
  private readonly bar = el('progress', { max: '1', 'aria-label': 'Compilation of the laws' });
  readonly element = el('p', { class: 'readiness', hidden: '' }, this.text, this.bar);
  /** What the station has sent last. */
  private state = READY;

  set(state: Readiness): void {
    this.state = state;
    const text = readinessText(state);
    setText(this.text, text);
    setClass(this.element, 'waits', this.stands);
    this.element.hidden = text === '';
    this.bar.hidden = state.share === null;
    this.bar.value = state.share ?? 0;
  }

  /** Whether the run stands still, so that no frames arrive. */
  get stands(): boolean {
    return this.state.waits_for !== '';
  }
}

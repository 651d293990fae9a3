/** Says what is not ready yet: in the rail, how long the laws are compiled; over the monitors, that the run waits. */

import type { Readiness } from '../link/protocol';
import { el, setAttribute, setText } from '../panel/parts/dom';

const READY: Readiness = { type: 'readiness', waits_for: '', share: null, left_s: null, failure: '' };
const COMPILING =
  'The laws are compiled, once for each version of them. Until then the arm flies by the same laws as plain ' +
  'Python, and there is no look-ahead.';

/** Sentence about what the run waits for; empty if it goes on. */
export function waitingText({ waits_for, left_s }: Readiness): string {
  if (waits_for === '') return '';
  if (waits_for === 'page') return 'The run begins when the page in control has drawn its first pictures.';
  return `The run waits for compiled laws, ${leftText(left_s)}: this step is too slow without them.`;
}

function leftText(left_s: number | null): string {
  return left_s === null ? 'a minute or two' : `${left_s} s`;
}

export class ReadinessNotice {
  /** Over the monitors, while the run waits. */
  readonly element = el('p', { class: 'waiting', role: 'status', hidden: '' });
  private readonly text = el('b');
  private readonly bar = el('progress', { max: '1', 'aria-label': 'Compilation of the laws' });
  /** In the rail, while the laws are compiled, or if that has failed. */
  readonly compiling = el('span', { class: 'compiling', hidden: '' }, this.text, this.bar);
  /** What the station has sent last. */
  private state = READY;

  set(state: Readiness): void {
    this.state = state;
    const { share, left_s, failure } = state;
    setText(this.element, waitingText(state));
    this.element.hidden = !this.stands;
    this.compiling.hidden = share === null && failure === '';
    setText(this.text, share === null ? 'Not compiled' : `Compiling ${leftText(left_s)}`);
    setAttribute(this.compiling, 'title', failure === '' ? COMPILING : `No look-ahead: ${failure}`);
    this.bar.hidden = share === null;
    this.bar.value = share ?? 0;
  }

  /** Whether the run stands still, so that no frames arrive. */
  get stands(): boolean {
    return this.state.waits_for !== '';
  }
}

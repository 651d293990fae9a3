/** CMD CK: whether the way to the target is clear. */

import type { Check } from '../protocol';
import { el, setAttribute, setClass, setText } from './dom';

export interface Verdict {
  readonly element: HTMLElement;
  set(check: Check | null): void;
}

export function verdict(): Verdict {
  const sign = el('i', { class: 'sign' });
  const text = el('span');
  const element = el('p', { class: 'check' }, el('b', {}, 'Cmd ck'), sign, text);
  return {
    element,
    set(check) {
      element.hidden = check === null;
      setClass(element, 'good', check?.good === true);
      setClass(element, 'caution', check?.good === false);
      setText(text, check?.text ?? '');
      setAttribute(element, 'title', check?.text ?? '');
    },
  };
}

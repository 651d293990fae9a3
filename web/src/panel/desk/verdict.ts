/** CMD CK: shows CHECKING while the motion to the target is rehearsed, then the verdict. */

import type { Frame } from '../../link/protocol';
import { el, setAttribute, setClass, setText } from '../parts/dom';

export interface Verdict {
  readonly element: HTMLElement;
  set(frame: Pick<Frame, 'check' | 'sequence'>): void;
}

export function verdict(): Verdict {
  const sign = el('i', { class: 'sign' });
  const text = el('span');
  const element = el('p', { class: 'check' }, el('b', {}, 'Cmd ck'), sign, text);
  return {
    element,
    set({ check, sequence }) {
      const shown = sequence === 'checking' ? 'CHECKING' : (check?.text ?? '');
      element.hidden = shown === '';
      setClass(element, 'good', check?.good === true);
      setClass(element, 'caution', check?.good === false);
      setText(text, shown);
      setAttribute(element, 'title', shown);
    },
  };
}

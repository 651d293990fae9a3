/** Asks the user whether two devices are assigned correctly to THC and RHC. */

import type { Pads } from '../../input/pads';
import { button, el, setText } from '../parts/dom';

export interface SwapQuestion {
  readonly element: HTMLElement;
  show(): void;
}

export function swapQuestion(pads: Pads): SwapQuestion {
  const words = el('p', { role: 'status' });
  const element = el(
    'section',
    { class: 'swap', 'aria-label': 'Two devices', hidden: '' },
    words,
    button({}, ['Swap'], () => pads.swap()),
    button({}, ['Keep'], () => pads.keep()),
  );
  return {
    element,
    show() {
      if (element.hidden === pads.asks) element.hidden = !pads.asks;
      const [thc, rhc] = pads.devices;
      if (!pads.asks || !thc || !rhc) return;
      setText(words, `Two devices: ${thc.short} is the THC, and ${rhc.short} is the RHC. Swap?`);
    },
  };
}

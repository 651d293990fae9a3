/** Notice over MON 1 that offers a pair of cameras, with the button that shows it. */

import type { PairOffer } from '../../cameras/pair-offer';
import type { Names } from '../../input/active-device';
import { button, el, setAttribute, setText } from '../parts/dom';

export interface PairNotice {
  readonly element: HTMLElement;
  /** Shows an offer; null hides the notice. */
  show(offer: PairOffer | null): void;
}

/** `take` shows the offered pair; `leave` rejects it; `inUse` returns those of the device in use. */
export function pairNotice(take: () => void, leave: () => void, inUse: () => Names): PairNotice {
  const words = el('span');
  const names = el('span');
  const key = el('kbd');
  const element = el(
    'p',
    { class: 'pair-offer', role: 'status', hidden: '' },
    words,
    button({ title: 'Show this pair of cameras on the monitors' }, [names, ' ', key], take),
    button({ title: 'Keep the cameras', 'aria-label': 'Keep the cameras' }, ['×'], leave),
  );
  return {
    element,
    show(offer) {
      element.hidden = offer === null;
      if (!offer) return;
      setText(words, 'Suggested views:');
      setAttribute(words, 'title', offer.why);
      setText(names, `Cameras ${offer.cameras.join(', ')}`);
      setText(key, inUse().name('offered pair'));
    },
  };
}

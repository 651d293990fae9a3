/** A switch of the panel that is also a function of a key: its button shows whether it is on, and names the key. */

import type { Names } from '../../input/active-device';
import type { Use } from '../../link/protocol';
import { button, el, setPressed, setText } from './dom';
import type { Desk } from './part';

export interface SwitchButton {
  readonly element: HTMLButtonElement;
  /** `names`: those of the device in use. */
  set(on: boolean, names: Names): void;
}

export function switchButton(
  desk: Desk,
  use: Use,
  { label, title, kind }: Readonly<Record<'label' | 'title' | 'kind', string>>,
): SwitchButton {
  const key = el('small');
  const element = button({ class: kind, 'data-calm': use, title }, [el('b', {}, label), ' ', key], () =>
    desk.act(use),
  );
  return {
    element,
    set(on, names) {
      setPressed(element, on);
      setText(key, names.short(use));
    },
  };
}

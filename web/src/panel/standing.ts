/** BRAKES and SAFING: what makes the joints stand, whatever the sticks ask. */

import type { GripAction } from '../input/keymap';
import { button, el, setAttribute, setClass, setPressed } from './dom';
import { holdButton } from './hold-button';
import type { Desk, View } from './part';

/** Brakes are let go only by holding their switch this long [s]; they are on at once. */
const OFF_S = 0.5;

export interface Standing {
  readonly element: HTMLElement;
  /** The brakes' key or button went down or up. */
  grip(action: GripAction): void;
  bars(): void;
  values(view: View): void;
}

export function standing(desk: Desk): Standing {
  let on = false;
  let safed = false;
  const letGo = () => desk.send({ type: 'brakes', on: false });
  const brakes = holdButton('Brakes', 'brakes', OFF_S, letGo, () => {
    if (!on) desk.send({ type: 'brakes', on: true });
    return on;
  });
  const safing = button(
    { class: 'safing', title: 'Commands zero joint rates, until it is cancelled' },
    ['Safing'],
    () => desk.send({ type: 'safing', on: !safed }),
  );
  return {
    element: el('div', { class: 'standing' }, brakes.element, safing),
    grip({ down, at }) {
      if (down) brakes.press(at);
      else brakes.lift(at);
    },
    bars: () => brakes.tick(),
    values({ frame }) {
      on = frame.brakes;
      safed = frame.safing;
      setPressed(brakes.element, on);
      setPressed(safing, safed);
      setClass(brakes.element, 'caution', on);
      setClass(safing, 'caution', safed);
      setAttribute(brakes.element, 'title', on ? `Hold ${OFF_S} s to let go` : 'Every joint stands at once');
    },
  };
}

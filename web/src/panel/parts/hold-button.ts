/** A button that acts after it has been held for a set time, by pointer, by Enter, or by its assigned key. */

import type { Grip } from '../../input/action';
import type { Names } from '../../input/active-device';
import { Hold } from '../../input/hold';
import { onPress } from '../../input/press';
import { el, setAttribute, setText } from './dom';

export interface HoldButton {
  readonly element: HTMLButtonElement;
  /** Called when the assigned key is pressed or released at `at` [ms, as performance.now()]. */
  press(at: number): void;
  lift(at: number): void;
  /** Fills the button's bar with the elapsed time; acts when the time is over. `names`: those of the device in use. */
  tick(names: Names): void;
}

/** `grip`: function of the assigned key; `begins`, called at a press, returns whether holding has an effect now. */
export function holdButton(
  label: string,
  grip: Grip,
  seconds: number,
  act: () => void,
  begins: () => boolean = () => true,
): HoldButton {
  const hold = new Hold(seconds, act);
  const press = (at: number) => {
    if (begins()) hold.press(at);
  };
  const fill = el('i', { class: 'fill' });
  const key = el('small');
  const element = el(
    'button',
    {
      type: 'button',
      class: 'hold-button',
      title: `Hold ${seconds} s`,
    },
    fill,
    el('b', {}, label),
    ' ',
    key,
  );
  let filled = 0;
  onPress(element, ({ timeStamp }) => {
    press(timeStamp);
    return { ended: (at) => hold.lift(at) };
  });
  for (const ends of ['pointerleave', 'blur'] as const) {
    element.addEventListener(ends, ({ timeStamp }) => hold.lift(timeStamp));
  }
  element.addEventListener('keydown', (event) => {
    if (event.key !== 'Enter') return;
    event.preventDefault();
    if (!event.repeat) press(event.timeStamp);
  });
  element.addEventListener('keyup', (event) => {
    if (event.key === 'Enter') hold.lift(event.timeStamp);
  });
  element.addEventListener('click', (event) => {
    if (event.detail > 0) element.blur();
    else if (begins()) act(); // a click without pointer or key: from an assistive device that cannot hold a button
  });
  return {
    element,
    press,
    lift: (at) => hold.lift(at),
    tick(names) {
      const part = hold.tick(performance.now());
      if (part !== filled) fill.style.transform = `scaleX(${part.toFixed(3)})`;
      filled = part;
      setText(key, names.short(grip));
      setAttribute(
        element,
        'aria-label',
        `${label} ${names.name(grip)}, hold ${seconds} s`.replace(' ,', ','),
      );
    },
  };
}

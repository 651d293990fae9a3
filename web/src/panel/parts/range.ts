/** Slider for a number, with the value as text beside it. */

import { el, setText } from './dom';

export interface Range {
  readonly element: HTMLElement;
  show(value: number, there: boolean): void;
}

export function range(
  name: string,
  most: number,
  step: number,
  words: (value: number) => string,
  changed: (value: number) => void,
): Range {
  const input = el('input', {
    type: 'range',
    min: '0',
    max: String(most),
    step: String(step),
    'aria-label': name,
  });
  const output = el('output');
  const element = el('label', { class: 'range' }, name, input, output);
  input.addEventListener('input', () => changed(Number(input.value)));
  return {
    element,
    show(value, there) {
      if (element.hidden === there) element.hidden = !there;
      if (Number(input.value) !== value) input.value = String(value);
      setText(output, words(value));
      input.setAttribute('aria-valuetext', words(value));
    },
  };
}

/** The touch sticks: two sticks and two sliders over the lower corners of the pictures. Only a drag moves them. */

import type { TouchSticks } from '../../input/touch';
import { button, el } from '../parts/dom';

/** Travel of a finger for full deflection [rem]. */
const TRAVEL = 3;

interface Knob {
  readonly element: HTMLElement;
  /** Draws the knob at its present deflection. */
  draw(): void;
}

export interface TouchView {
  readonly element: HTMLElement;
  draw(): void;
}

export function touchView(sticks: TouchSticks): TouchView {
  const left = knob(sticks, 0, 1, 'round');
  const height = knob(sticks, null, 2, 'upright');
  const right = knob(sticks, 3, 4, 'round');
  const roll = knob(sticks, 5, null, 'level');
  const knobs = [left, height, right, roll];
  const close = button({ class: 'away', 'aria-label': 'Hide the touch sticks' }, ['Hide'], () =>
    sticks.hide(),
  );
  const element = el(
    'div',
    { class: 'touch', role: 'group', 'aria-label': 'Touch sticks', hidden: '' },
    el('div', { class: 'left' }, named('THC: X, Y', left.element), named('Z', height.element)),
    el(
      'div',
      { class: 'right' },
      el('div', { class: 'over' }, close, named('roll', roll.element)),
      named('RHC: pitch, yaw', right.element),
    ),
  );
  element.addEventListener('contextmenu', (event) => event.preventDefault());
  return {
    element,
    draw() {
      if (element.hidden === sticks.shown) element.hidden = !sticks.shown;
      if (sticks.shown) for (const each of knobs) each.draw();
    },
  };
}

/**
 * Makes a stick or slider. `across`: axis that a horizontal drag moves; `down`: axis that a vertical drag moves. Null
 * if a drag in this direction moves no axis.
 */
function knob(sticks: TouchSticks, across: number | null, down: number | null, shape: string): Knob {
  const cap = el('i');
  const element = el('div', { class: `knob ${shape}` }, cap);
  let finger: { readonly id: number; readonly x: number; readonly y: number } | null = null;
  const put = (x: number, y: number) => {
    const far = across !== null && down !== null ? Math.max(1, Math.hypot(x, y)) : 1;
    if (across !== null) sticks.put(across, x / far);
    if (down !== null) sticks.put(down, y / far);
  };
  element.addEventListener('pointerdown', (event) => {
    event.preventDefault();
    if (finger) return;
    element.setPointerCapture(event.pointerId);
    finger = { id: event.pointerId, x: event.clientX, y: event.clientY };
  });
  element.addEventListener('pointermove', (event) => {
    if (finger?.id !== event.pointerId) return;
    const rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
    put((event.clientX - finger.x) / (TRAVEL * rem), (event.clientY - finger.y) / (TRAVEL * rem));
  });
  for (const ends of ['pointerup', 'pointercancel', 'lostpointercapture'] as const) {
    element.addEventListener(ends, (event) => {
      if (finger?.id !== event.pointerId) return;
      finger = null;
      put(0, 0);
    });
  }
  return {
    element,
    draw() {
      const x = across === null ? 0 : sticks.value(across);
      const y = down === null ? 0 : sticks.value(down);
      cap.style.translate = `${(x * TRAVEL * 0.8).toFixed(2)}rem ${(y * TRAVEL * 0.8).toFixed(2)}rem`;
    },
  };
}

function named(name: string, knob: HTMLElement): HTMLElement {
  return el('div', { class: 'named' }, knob, el('span', {}, name));
}

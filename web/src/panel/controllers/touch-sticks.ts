/** The touch sticks: two sticks and two sliders over the lower corners of the pictures. Only a drag moves them. */

import { onPress } from '../../input/press';
import type { Pulses } from '../../input/pulses';
import type { TouchSticks } from '../../input/touch';
import { button, el, setPressed } from '../parts/dom';

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

export function touchView(sticks: TouchSticks, pulses: Pulses): TouchView {
  const left = knob(sticks, 0, 1, 'round');
  const height = knob(sticks, null, 2, 'upright');
  const right = knob(sticks, 3, 4, 'round');
  const roll = knob(sticks, 5, null, 'level');
  const knobs = [left, height, right, roll];
  const close = button({ class: 'away', 'aria-label': 'Hide the touch sticks' }, ['Hide'], () =>
    sticks.hide(),
  );
  const pulse = button({ class: 'away' }, ['Pulse'], () => {
    pulses.on = !pulses.on;
  });
  const element = el(
    'div',
    { class: 'touch', role: 'group', 'aria-label': 'Touch sticks', hidden: '' },
    el('div', { class: 'left' }, named('THC: X, Y', left.element), named('Z', height.element)),
    el(
      'div',
      { class: 'right' },
      el('div', { class: 'over' }, close, pulse, named('roll', roll.element)),
      named('RHC: pitch, yaw', right.element),
    ),
  );
  element.addEventListener('contextmenu', (event) => event.preventDefault());
  return {
    element,
    draw() {
      if (element.hidden === sticks.shown) element.hidden = !sticks.shown;
      setPressed(pulse, pulses.active);
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
  const axes = [across, down].filter((axis) => axis !== null);
  let touched = false;
  onPress(element, (event) => {
    event.preventDefault();
    if (touched) return null;
    const { pointerId, clientX, clientY } = event;
    element.setPointerCapture(pointerId);
    sticks.press(pointerId);
    touched = true;
    return {
      moved(at) {
        const travel = TRAVEL * parseFloat(getComputedStyle(document.documentElement).fontSize);
        const [x, y] = [(at.clientX - clientX) / travel, (at.clientY - clientY) / travel];
        const far = across !== null && down !== null ? Math.max(1, Math.hypot(x, y)) : 1;
        if (across !== null) sticks.put(pointerId, across, x / far);
        if (down !== null) sticks.put(pointerId, down, y / far);
      },
      ended() {
        touched = false;
        sticks.lift(pointerId, axes);
      },
    };
  });
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

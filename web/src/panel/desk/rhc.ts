/** Rotational hand controller. */

import { PITCH, ROLL, YAW } from '../../input/deflection';
import { el, group, setAttribute, setClass, svg } from '../parts/dom';
import type { Part } from '../parts/part';
import { gone, mark, setHand, triple } from './sticks';

const ROLL_SPAN = 75;

export function rhc(): Part {
  const lost = gone('M-35 -35 L35 35 M-35 35 L35 -35');
  const tilt = mark();
  const heldTilt = mark(true);
  const roll = svg('circle', { class: 'mark', r: '5.5', cx: '0', cy: '-32' });
  const heldRoll = svg(
    'g',
    { class: 'held' },
    svg('circle', { class: 'mark', r: '8.5', cx: '0', cy: '-32' }),
  );
  const numbers = triple(['P', 'Y', 'R']);
  const element = group(
    'rhc',
    'RHC',
    el(
      'div',
      { class: 'sticks' },
      el(
        'div',
        { class: 'stick' },
        el('span', {}, '+pitch'),
        svg(
          'svg',
          { viewBox: '-50 -50 100 100', 'aria-hidden': 'true' },
          svg('circle', { class: 'well', r: '49' }),
          svg('path', { class: 'cross', d: 'M-40 0 H40 M0 -40 V40' }),
          lost.ring,
          lost.cross,
          heldTilt.element,
          tilt.element,
        ),
        el('span', {}, 'yaw left, right'),
        lost.words,
      ),
      el(
        'div',
        { class: 'stick arc' },
        el('span', {}, 'roll'),
        svg(
          'svg',
          { viewBox: '-42 -44 84 56', 'aria-hidden': 'true' },
          svg('path', { class: 'arc', d: 'M-30.9 -8.3 A32 32 0 0 1 30.9 -8.3' }),
          heldRoll,
          roll,
        ),
      ),
    ),
    numbers.element,
  );
  return {
    element,
    bars({ frame, hand, flying }) {
      const [rollNow, pitch, yaw] = frame.rotation;
      heldTilt.set(yaw, pitch);
      turn(heldRoll, rollNow);
      setClass(heldRoll, 'middle', rollNow === 0);
      const own = frame.rate_hold && flying;
      tilt.set(own ? (hand[YAW] ?? 0) : yaw, own ? (hand[PITCH] ?? 0) : pitch);
      turn(roll, own ? (hand[ROLL] ?? 0) : rollNow);
    },
    values({ frame, flying, flier, controllers }) {
      lost.set(element, controllers, 'rhc');
      const [rollNow, pitch, yaw] = frame.rotation;
      setHand(element, 'right hand', { frame, flying, flier });
      numbers.set([pitch, yaw, rollNow]);
      setClass(element, 'holding', frame.rate_hold);
    },
  };
}

function turn(mark: Element, roll: number): void {
  setAttribute(mark, 'transform', `rotate(${(roll * ROLL_SPAN).toFixed(1)})`);
}

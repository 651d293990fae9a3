/** Translational hand controller: it moves the arm or the orbiter. Also the rate setting and RATE HOLD of the arm. */

import { X, Y, Z } from '../../input/deflection';
import { button, el, group, setAttribute, setClass, setPressed, setText, svg } from '../parts/dom';
import type { Desk, Part } from '../parts/part';
import { isMoving, orbiterReading } from './orbiter';
import { gone, mark, setHand, triple } from './sticks';

/** `flyOrbiter` assigns the THC to the orbiter, or to the arm; `pulse` switches PULSE, undefined in a replay. */
export function thc(desk: Desk, flyOrbiter: (on: boolean) => void, pulse?: () => void): Part {
  const [up, down] = [el('span'), el('span')];
  const [lift, drop] = [el('span'), el('span')];
  const device = gone('M-49 -49 L49 49 M-49 49 L49 -49');
  const plane = mark();
  const height = mark();
  const heldPlane = mark(true);
  const heldHeight = mark(true);
  const numbers = triple(['X', 'Y', 'Z']);
  const coarse = button({}, ['Coarse'], () => desk.send({ type: 'select_rate', rate: 'coarse' }));
  const vernier = button({}, ['Vernier'], () => desk.send({ type: 'select_rate', rate: 'vernier' }));
  const hold = button(
    { class: 'hold', title: 'Keep the present rates while the sticks are centred', 'data-calm': 'rate hold' },
    ['Rate hold'],
    () => desk.act('rate hold'),
  );
  const pulses = button({ class: 'hold', title: PULSE, 'data-calm': 'pulse' }, ['Pulse'], () => pulse?.());
  const arm = button({}, ['Arm'], () => flyOrbiter(false));
  const orbiter = button({ title: 'Translate the orbiter with the THC' }, ['Orbiter'], () =>
    flyOrbiter(true),
  );
  const assignment = el(
    'div',
    { class: 'switch flies', role: 'group', 'aria-label': 'THC moves', 'data-calm': 'fly orbiter' },
    arm,
    orbiter,
  );
  assignment.hidden = desk.welcome.work.cargo.length === 0;
  const reading = orbiterReading();
  const rates = el('div', { class: 'switch', role: 'group', 'aria-label': 'Rate' }, coarse, vernier);
  const holds = el('div', { class: 'holds' }, hold, ...(pulse ? [pulses] : []));
  const element = group(
    'thc',
    'THC',
    el(
      'div',
      { class: 'sticks' },
      el(
        'div',
        { class: 'stick' },
        up,
        svg(
          'svg',
          { viewBox: '-50 -50 100 100', 'aria-hidden': 'true' },
          svg('rect', { class: 'well', x: '-49', y: '-49', width: '98', height: '98' }),
          svg('path', { class: 'cross', d: 'M-40 0 H40 M0 -40 V40' }),
          device.ring,
          device.cross,
          heldPlane.element,
          plane.element,
        ),
        down,
        device.words,
      ),
      el(
        'div',
        { class: 'stick slider' },
        lift,
        svg(
          'svg',
          { viewBox: '-12 -50 24 100', 'aria-hidden': 'true' },
          svg('rect', { class: 'well', x: '-6', y: '-49', width: '12', height: '98' }),
          svg('path', { class: 'cross', d: 'M-6 0 H6' }),
          heldHeight.element,
          height.element,
        ),
        drop,
      ),
    ),
    numbers.element,
    assignment,
    reading.element,
    rates,
    holds,
  );
  return {
    element,
    bars({ frame, hand, flying, orbiting }) {
      const [x, y, z] = frame.translation;
      heldPlane.set(y, x);
      heldHeight.set(0, -z);
      const own = orbiting || (frame.rate_hold && flying);
      plane.set(own ? (hand[Y] ?? 0) : y, own ? (hand[X] ?? 0) : x + frame.drive);
      height.set(0, own ? -(hand[Z] ?? 0) : -z);
    },
    values({ frame, flying, flier, hand, orbiting, units, controllers }) {
      device.set(element, controllers, 'thc');
      const mode = desk.welcome.modes.find((each) => each.position === frame.mode);
      const driving = mode?.kind === 'single' && !orbiting;
      const [x, , z] = orbiting ? ORBITER_AXES : (mode?.axis_names ?? ['+X', '+Y', '+Z']);
      setText(up, driving ? '+ drive' : x);
      setText(down, driving ? '− drive' : opposite(x));
      setText(lift, driving ? '' : opposite(z));
      setText(drop, driving ? '' : z);
      setClass(element, 'driving', driving);
      setHand(element, orbiting ? 'moves the orbiter' : 'left hand', { frame, flying, flier });
      setClass(element, 'orbiting', orbiting);
      setPressed(arm, !orbiting);
      setPressed(orbiter, orbiting);
      reading.element.hidden = !orbiting;
      rates.hidden = holds.hidden = orbiting;
      reading.set(frame.display, units);
      setClass(orbiter, 'moving', isMoving(frame.display));
      if (orbiting) numbers.set([hand[X] ?? 0, hand[Y] ?? 0, hand[Z] ?? 0], 'X');
      else if (driving) numbers.set([frame.drive, 0, 0], 'Drive');
      else numbers.set(frame.translation, 'X');
      setAttribute(numbers.element, 'aria-label', 'Translation sticks');
      setClass(element, 'holding', frame.rate_hold && !orbiting);
      setPressed(hold, frame.rate_hold);
      setPressed(pulses, controllers.pulsing);
      setPressed(coarse, frame.rate === 'coarse');
      setPressed(vernier, frame.rate === 'vernier');
    },
  };
}

const PULSE = 'Each push of a stick or key moves the arm by 0.1 in or 0.1°';

/** Positive directions of the THC while it moves the orbiter. */
const ORBITER_AXES = ['+X fwd', '+Y stbd', '+Z down'] as const;

const OPPOSITES: Readonly<Record<string, string>> = {
  fwd: 'aft',
  aft: 'fwd',
  out: 'back',
  up: 'dn',
  down: 'up',
  dn: 'up',
  left: 'right',
  right: 'left',
};

/** Returns the opposite direction: `−X aft` for `+X fwd`. If the word has no opposite, returns only the axis. */
export function opposite(name: string): string {
  const [axis = '', word = ''] = name.replace('+', '−').split(' ');
  const other = OPPOSITES[word];
  return other === undefined ? axis : `${axis} ${other}`;
}

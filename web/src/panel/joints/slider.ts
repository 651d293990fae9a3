/** One joint of the master arm: a slider at the commanded angle, on a bar with a pointer at the actual angle. */

import { onPress } from '../../input/press';
import type { JointInfo } from '../../link/protocol';
import { degrees } from '../../words/format';
import { el, setAttribute, svg } from '../parts/dom';
import { jointBar, range } from './joint-bar';
import { angleAt, BAR, place } from './joint-scale';

const DEGREE = Math.PI / 180;
/** Steps of the arrow keys and of Page up and down [rad]. */
const STEP = 0.5 * DEGREE;
const PAGE = 5 * DEGREE;
/** The bar's margin at either end, in the units of its view box. */
const MARGIN = 3;

export interface Slider {
  readonly element: HTMLElement;
  /** Angles of the joint and of its slider [rad]. */
  set(actual: number, commanded: number): void;
}

/** `moved` is called with each angle [rad] that the operator sets. */
export function slider(joint: JointInfo, moved: (angle: number) => void): Slider {
  const thumb = svg('path', { class: 'commanded', d: 'M-5.5 -2 H5.5 L0 8 Z' });
  const bar = jointBar(joint, thumb);
  const [least, greatest] = joint.hard;
  let commanded = 0;
  const element = el(
    'div',
    {
      class: 'slider',
      role: 'slider',
      tabindex: '0',
      'aria-label': `Master ${joint.label}`,
      'aria-valuemin': degrees(least),
      'aria-valuemax': degrees(greatest),
      title: range(joint),
    },
    bar.element,
  );
  const put = (angle: number) => {
    commanded = Math.min(greatest, Math.max(least, angle));
    moved(commanded);
  };
  // A drag moves the slider by as much as the pointer moves, so that a press without motion does not move the arm.
  onPress(element, ({ pointerId, clientX }) => {
    element.setPointerCapture(pointerId);
    const from = place(joint, commanded);
    return {
      moved(at) {
        const per = (BAR + 2 * MARGIN) / bar.element.getBoundingClientRect().width;
        put(angleAt(joint, from + (at.clientX - clientX) * per));
      },
      ended() {},
    };
  });
  element.addEventListener('keydown', (event) => {
    const by = STEPS[event.key];
    const end = event.key === 'Home' ? joint.reach[0] : event.key === 'End' ? joint.reach[1] : null;
    if (by === undefined && end === null) return;
    event.preventDefault();
    put(end ?? commanded + (by ?? 0));
  });
  return {
    element,
    set(actual, goal) {
      commanded = goal;
      bar.set(actual);
      setAttribute(thumb, 'transform', `translate(${place(joint, goal).toFixed(2)} 0)`);
      setAttribute(element, 'aria-valuenow', String(Math.round((goal / DEGREE) * 10) / 10));
      setAttribute(element, 'aria-valuetext', `${degrees(goal)} degrees, joint at ${degrees(actual)}`);
    },
  };
}

const STEPS: Readonly<Record<string, number>> = {
  ArrowRight: STEP,
  ArrowUp: STEP,
  ArrowLeft: -STEP,
  ArrowDown: -STEP,
  PageUp: PAGE,
  PageDown: -PAGE,
};

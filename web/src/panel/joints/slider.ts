/** One joint of the master arm: a slider at the commanded coordinate, on a bar with a pointer at the actual one. */

import { onPress } from '../../input/press';
import type { JointInfo } from '../../link/protocol';
import { coordinateNumber, coordinatesSaid, keySteps, rangeText } from '../../words/joint';
import type { Units } from '../../words/units';
import { el, setAttribute, svg } from '../parts/dom';
import { jointBar } from './joint-bar';
import { BAR, coordinateAt, place } from './joint-scale';

/** The bar's margin at either end, in the units of its view box. */
const MARGIN = 3;

export interface Slider {
  readonly element: HTMLElement;
  /** Sets the coordinates of the joint and of its slider [rad or m]. */
  set(actual: number, commanded: number, units: Units): void;
}

/** `moved` is called with each coordinate [rad or m] that the operator sets. */
export function slider(joint: JointInfo, moved: (coordinate: number) => void): Slider {
  const thumb = svg('path', { class: 'commanded', d: 'M-5.5 -2 H5.5 L0 8 Z' });
  const bar = jointBar(joint, thumb);
  const [least, greatest] = joint.hard;
  const [step, page] = keySteps(joint);
  let commanded = 0;
  let shown: Units | null = null;
  const element = el(
    'div',
    {
      class: 'slider',
      role: 'slider',
      tabindex: '0',
      'aria-label': `Master ${joint.label}`,
    },
    bar.element,
  );
  const put = (coordinate: number) => {
    commanded = Math.min(greatest, Math.max(least, coordinate));
    moved(commanded);
  };
  // A drag moves the slider by as much as the pointer moves, so that a press without motion does not move the arm.
  onPress(element, ({ pointerId, clientX }) => {
    element.setPointerCapture(pointerId);
    const from = place(joint, commanded);
    return {
      moved(at) {
        const per = (BAR + 2 * MARGIN) / bar.element.getBoundingClientRect().width;
        put(coordinateAt(joint, from + (at.clientX - clientX) * per));
      },
      ended() {},
    };
  });
  element.addEventListener('keydown', (event) => {
    const by = (ARROWS[event.key] ?? 0) * step + (PAGES[event.key] ?? 0) * page;
    const end = event.key === 'Home' ? joint.reach[0] : event.key === 'End' ? joint.reach[1] : null;
    if (by === 0 && end === null) return;
    event.preventDefault();
    put(end ?? commanded + by);
  });
  return {
    element,
    set(actual, goal, units) {
      commanded = goal;
      if (units !== shown) {
        shown = units;
        setAttribute(element, 'aria-valuemin', coordinateNumber(joint, least, units));
        setAttribute(element, 'aria-valuemax', coordinateNumber(joint, greatest, units));
        setAttribute(element, 'title', rangeText(joint, units));
      }
      bar.set(actual);
      setAttribute(thumb, 'transform', `translate(${place(joint, goal).toFixed(2)} 0)`);
      setAttribute(element, 'aria-valuenow', coordinateNumber(joint, goal, units));
      setAttribute(element, 'aria-valuetext', coordinatesSaid(joint, goal, actual, units));
    },
  };
}

const ARROWS: Readonly<Record<string, number>> = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 };
const PAGES: Readonly<Record<string, number>> = { PageUp: 1, PageDown: -1 };

/** Bar of a joint: a pointer shows its coordinate; at both ends are the zones of its limits. */

import type { JointInfo } from '../../link/protocol';
import { setAttribute, svg } from '../parts/dom';
import { BAR, place } from './joint-scale';

export interface JointBar {
  readonly element: SVGSVGElement;
  /** Puts the pointer at a coordinate [rad or m]. */
  set(coordinate: number): void;
}

/** `marks` are drawn over the bar, in the units of its view box. */
export function jointBar(joint: JointInfo, ...marks: SVGElement[]): JointBar {
  const pointer = svg('path', { class: 'pointer', d: 'M0 11 L4.5 20 H-4.5 Z M-0.9 0 H0.9 V12 H-0.9 Z' });
  const zero = place(joint, 0).toFixed(1);
  const element = svg(
    'svg',
    {
      class: 'joint-bar',
      viewBox: `-3 0 ${BAR + 6} 20`,
      preserveAspectRatio: 'none',
      'aria-hidden': 'true',
    },
    svg('rect', { class: 'track', x: '0', y: '7', width: String(BAR), height: '5' }),
    ...zones(),
    svg('path', { class: 'tick', d: `M${zero} 5 V14` }),
    pointer,
    ...marks,
  );
  return {
    element,
    set(coordinate) {
      setAttribute(pointer, 'transform', `translate(${place(joint, coordinate).toFixed(2)} 0)`);
    },
  };
}

function zones(): SVGElement[] {
  const rect = (name: string, x: number) =>
    svg('rect', { class: name, x: String(x), y: '6', width: '9', height: '7' });
  const hatch = (x: number) =>
    svg('path', { class: 'hatch', d: `M${x + 1} 13 l3.5 -7 M${x + 4.5} 13 l3.5 -7` });
  const post = (x: number) =>
    svg('rect', { class: 'post', x: String(x - 1), y: '3', width: '2', height: '13' });
  return [
    ...[0, BAR - 9].flatMap((x) => [rect('soft', x), hatch(x)]),
    ...[9, BAR - 18].map((x) => rect('reach', x)),
    post(0),
    post(BAR),
  ];
}

/** Overlay of a picture: forces of contacts and disturbances, as arrows with their values. */

import { setAttribute, setText, svg } from '../parts/dom';
import type { Point } from './label-place';

/** An arrow in the picture [px], and its force [N]. */
export interface PushArrow {
  readonly from: Point;
  readonly to: Point;
  readonly newtons: number;
}

export interface PushOverlay {
  readonly element: SVGSVGElement;
  /** Draws the arrows, at picture rate. */
  show(arrows: readonly PushArrow[]): void;
}

/** Greatest number of arrows. */
const MOST = 8;
/** Length and half width of an arrow's head [px]. */
const [HEAD, HALF] = [11, 5];
/** Distance of the value from the arrow's point [px]. */
const BESIDE = 9;

export function pushOverlay(): PushOverlay {
  const arrows = Array.from({ length: MOST }, () => {
    const paths = ['edge', 'core'].map((name) => svg('path', { class: name }));
    const value = svg('text');
    return { paths, value, element: svg('g', { class: 'push' }, ...paths, value) };
  });
  return {
    element: svg('svg', { class: 'pushes', 'aria-hidden': 'true' }, ...arrows.map(({ element }) => element)),
    show(pushes) {
      arrows.forEach(({ element, paths, value }, i) => {
        const push = pushes[i];
        setAttribute(element, 'visibility', push ? 'visible' : 'hidden');
        if (!push) return;
        for (const path of paths) setAttribute(path, 'd', outline(push));
        const { x, y } = beyond(push);
        setAttribute(value, 'x', x.toFixed(0));
        setAttribute(value, 'y', y.toFixed(0));
        setAttribute(value, 'text-anchor', push.to.x < push.from.x ? 'end' : 'start');
        setText(value, `${push.newtons.toFixed(0)} N`);
      });
    },
  };
}

/** Returns the path of an arrow; its head is shorter than the arrow. */
function outline({ from, to }: PushArrow): string {
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  const [x, y] = length > 0 ? [(to.x - from.x) / length, (to.y - from.y) / length] : [1, 0];
  const head = Math.min(HEAD, length);
  const [left, right] = [1, -1].map((side) => ({
    x: to.x - head * x - side * HALF * y,
    y: to.y - head * y + side * HALF * x,
  })) as [Point, Point];
  const at = (point: Point) => `${point.x.toFixed(1)} ${point.y.toFixed(1)}`;
  return `M${at(from)} L${at(to)} M${at(left)} L${at(to)} L${at(right)}`;
}

/** Returns the place of the value, beyond the arrow's point. */
function beyond({ from, to }: PushArrow): Point {
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  if (length === 0) return { x: to.x + BESIDE, y: to.y };
  return { x: to.x + (BESIDE * (to.x - from.x)) / length, y: to.y + (BESIDE * (to.y - from.y)) / length + 4 };
}

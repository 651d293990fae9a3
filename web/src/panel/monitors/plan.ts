/** Plan view: position and direction of each camera, over the worksite as seen from above. */

import type { Camera, Vec3 } from '../../link/protocol';
import type { Extent } from '../../scene/overhead';
import { el, setAttribute, setClass, svg } from '../parts/dom';
import type { Size } from './label-place';

/** Length of a camera's wedge, as a fraction of the plan's length. */
const WEDGE = 0.11;
/** Sine of the steepest direction of view for which a wedge is drawn. */
const STEEP = 0.97;
/** Margin of the plan, as a fraction of its size. */
const MARGIN = 0.16;

export interface Mark {
  readonly camera: Camera;
  readonly lens: Vec3;
  readonly ahead: Vec3;
  /** Horizontal field of view [rad]. */
  readonly angle: number;
  /** Whether a monitor shows the camera. */
  readonly used: boolean;
}

export interface Plan {
  readonly element: HTMLElement;
  /** Transparent element over the scene's canvas. */
  readonly picture: HTMLElement;
  set(extent: Extent, marks: readonly Mark[], gap: Vec3 | null): void;
}

export function plan(cameras: readonly Camera[]): Plan {
  const marks = cameras.map(({ name }) => {
    const wedge = svg('path', { class: 'wedge' });
    const dot = svg('circle', { class: 'lens' });
    const label = svg('text', {}, name);
    return { wedge, dot, label, element: svg('g', { class: 'mark' }, wedge, dot, label) };
  });
  const gap = svg('circle', { class: 'gap' });
  const drawing = svg('svg', { 'aria-hidden': 'true' }, ...marks.map(({ element }) => element), gap);
  const picture = el('div', { class: 'plan-picture' }, drawing);
  return {
    element: picture,
    picture,
    set({ x, y, width, height }, seen, at) {
      setAttribute(drawing, 'viewBox', `${x} ${-y - height} ${width} ${height}`);
      // The text is as large as on the page, whatever the scale of the plan.
      const unit = height / Math.max(1, picture.clientHeight);
      const size = 12.5 * unit;
      marks.forEach((mark, i) => {
        const one = seen[i];
        if (!one) return;
        const [px, up] = one.lens;
        const [dx, ahead, dz] = one.ahead;
        const [py, dy] = [-up, -ahead]; // in an SVG, y points down
        setClass(mark.element, 'used', one.used);
        setAttribute(
          mark.wedge,
          'd',
          Math.abs(dz) > STEEP ? '' : wedge(px, py, Math.atan2(dy, dx), one.angle, width * WEDGE),
        );
        for (const [name, value] of [
          ['cx', px],
          ['cy', py],
          ['r', 2.6 * unit],
        ] as const)
          setAttribute(mark.dot, name, value.toFixed(2));
        // The name is behind the camera, clear of its wedge.
        const back = Math.hypot(dx, dy) || 1;
        setAttribute(mark.label, 'x', (px - (dx / back) * size * 0.9).toFixed(2));
        setAttribute(mark.label, 'y', (py - (dy / back) * size * 0.9).toFixed(2));
        setAttribute(mark.label, 'font-size', size.toFixed(3));
      });
      setAttribute(gap, 'visibility', at ? 'visible' : 'hidden');
      if (at) {
        setAttribute(gap, 'cx', at[0].toFixed(2));
        setAttribute(gap, 'cy', (-at[1]).toFixed(2));
        setAttribute(gap, 'r', (5 * unit).toFixed(3));
      }
    },
  };
}

function wedge(x: number, y: number, heading: number, angle: number, length: number): string {
  const corner = (side: number) => {
    const way = heading + (side * angle) / 2;
    return `${(x + length * Math.cos(way)).toFixed(2)} ${(y + length * Math.sin(way)).toFixed(2)}`;
  };
  return `M${x.toFixed(2)} ${y.toFixed(2)}L${corner(-1)}L${corner(1)}Z`;
}

/** Returns an extent that contains some points of the scene and has the aspect of a picture of this size. */
export function extentOf(places: readonly Vec3[], { width, height }: Size): Extent {
  const sides = [0, 1].map((k) => places.map((place) => place[k] ?? 0));
  const [left = 0, right = 0, low = 0, high = 0] = sides.flatMap((values) => [
    Math.min(...values),
    Math.max(...values),
  ]);
  const scale = (1 + 2 * MARGIN) * Math.max((right - left) / width, (high - low) / height);
  const [wide, tall] = [width * scale, height * scale];
  return { x: (left + right - wide) / 2, y: (low + high - tall) / 2, width: wide, height: tall };
}

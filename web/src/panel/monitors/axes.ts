/** Axes over a picture: the directions +X +Y +Z of the sticks as the camera sees them. */

import { clamp } from '../../basics/clamp';
import type { Vec3 } from '../../link/protocol';
import { setAttribute, setClass, setText, svg } from '../parts/dom';

const LENGTH = 34;
/** The ring is dashed above this angle [rad]: a little over 90°, so that a view straight down does not flicker. */
const CROSSED = Math.PI / 2 + 0.04;
/** An axis shorter than this in the picture counts as pointing towards the viewer or away from the viewer. */
const END_ON = 0.2;

const ABOUT =
  'Axes of the sticks as this camera sees them. Dashed ring: picture and sticks differ in direction by the angle shown';

export interface AxesOverlay {
  readonly element: SVGSVGElement;
  /** Axes as the camera sees them: x right, y up, z towards the viewer. */
  /** `marked`: whether the ring shows a large angle. It does not if the sticks drive one joint. */
  set(directions: readonly [Vec3, Vec3, Vec3], marked: boolean): void;
}

export function axesOverlay(): AxesOverlay {
  const ring = svg('circle', { class: 'disc', r: '48' });
  const angle = svg('text', { class: 'angle', x: '44', y: '40' });
  const axes = ['X', 'Y', 'Z'].map((name) => {
    const line = svg('line', { x1: '0', y1: '0' });
    const end = svg('circle', { class: 'end', r: '4' });
    const label = svg('text', {}, name);
    return { line, end, label, element: svg('g', { class: 'axis' }, line, end, label) };
  });
  const element = svg(
    'svg',
    { class: 'frame-axes', viewBox: '-50 -50 100 100', 'aria-hidden': 'true' },
    svg('title', {}, ABOUT),
    ring,
    ...axes.map(({ element: axis }) => axis),
    svg('circle', { class: 'origin', r: '3' }),
    angle,
  );
  return {
    element,
    set(directions, marked) {
      axes.forEach(({ line, end, label }, i) => {
        const [right = 0, up = 0, towards = 0] = directions[i] ?? [];
        const [x, y] = [right * LENGTH, -up * LENGTH];
        const size = Math.hypot(right, up);
        setAttribute(line, 'x2', x.toFixed(1));
        setAttribute(line, 'y2', y.toFixed(1));
        setAttribute(end, 'cx', x.toFixed(1));
        setAttribute(end, 'cy', y.toFixed(1));
        setClass(end, 'shown', size < END_ON);
        setClass(end, 'towards', towards > 0);
        const push = size < END_ON ? 9 : 8 / size;
        const side = size < END_ON ? 1 : 0;
        setAttribute(label, 'x', (x + (side ? 9 : right * push)).toFixed(1));
        setAttribute(label, 'y', (y + (side ? -9 : -up * push)).toFixed(1));
      });
      const apart = stickToPicture(directions);
      const crossed = marked && apart > CROSSED;
      setClass(ring, 'crossed', crossed);
      setText(angle, crossed ? `${Math.round((apart * 180) / Math.PI)}°` : '');
    },
  };
}

/**
 * Returns the angle between the picture's directions and the sticks' directions [rad]. The angle is zero if +X points
 * into the picture, +Y to the right and +Z down.
 */
export function stickToPicture([x, y, z]: readonly [Vec3, Vec3, Vec3]): number {
  const trace = -x[2] + y[0] - z[1];
  return Math.acos(clamp((trace - 1) / 2));
}

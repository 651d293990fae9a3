/** Divides pictures into rectangles. */

import type { Rect } from '../scene/drawn';

/** Returns the parts of a rectangle that no other rectangle covers. */
export function uncovered(rect: Rect, others: readonly Rect[]): readonly Rect[] {
  return others.reduce<readonly Rect[]>(
    (left, other) => left.flatMap((each) => without(each, other)),
    [rect],
  );
}

/** Divides a rectangle into rows, each with an area of at most `most`, or one px high. */
export function parts(rect: Rect, most: number): readonly Rect[] {
  const { left, top, width, height } = rect;
  const high = Math.max(1, Math.floor(most / width));
  return Array.from({ length: Math.ceil(height / high) }, (_, i) => ({
    ...{ left, width },
    top: top + i * high,
    height: Math.min(high, height - i * high),
  }));
}

/** Returns the rectangles above, below, left and right of another rectangle. */
function without(rect: Rect, other: Rect): readonly Rect[] {
  const [right, bottom] = [rect.left + rect.width, rect.top + rect.height];
  const [x0, x1] = [Math.max(rect.left, other.left), Math.min(right, other.left + other.width)];
  const [y0, y1] = [Math.max(rect.top, other.top), Math.min(bottom, other.top + other.height)];
  if (x0 >= x1 || y0 >= y1) return [rect];
  const between = (left: number, top: number, to: number, below: number) => ({
    ...{ left, top },
    width: to - left,
    height: below - top,
  });
  return [
    between(rect.left, rect.top, right, y0),
    between(rect.left, y1, right, bottom),
    between(rect.left, y0, x0, y1),
    between(x1, y0, right, y1),
  ].filter(({ width, height }) => width > 0 && height > 0);
}

/** The part of a picture that no other picture covers. */

import { ASPECT, type Part, type Rect } from './drawn';

type Size = Pick<Rect, 'width' | 'height'>;

/** The whole picture. */
export const WHOLE: Part = { left: 0, top: 0, width: 1, height: 1 };

/**
 * Returns the part of a picture in which a camera shows its field of view: the whole picture, or beside pictures that
 * cover it the strip in which the field is largest.
 */
export function freePart(rect: Rect, covers: readonly Rect[]): Part {
  if (!(rect.width > 0 && rect.height > 0)) return WHOLE;
  let best = rect;
  for (const cover of covers) {
    const strips = besides(best, cover);
    best = strips.reduce((one, other) => (fieldOf(other) > fieldOf(one) ? other : one), strips[0] ?? best);
  }
  return {
    left: (best.left - rect.left) / rect.width,
    top: (best.top - rect.top) / rect.height,
    width: best.width / rect.width,
    height: best.height / rect.height,
  };
}

/** Returns the size of a picture's free part [CSS px]. */
export function freeSize({ rect, free }: { readonly rect: Rect; readonly free: Part }): Size {
  return { width: rect.width * free.width, height: rect.height * free.height };
}

/** Returns the width that a camera's field of view has in a picture [CSS px]. */
export function fieldOf({ width, height }: Size): number {
  return Math.min(width, ASPECT * height);
}

/** Returns the whole strips of a rectangle left of, right of, above and below another; itself if they do not overlap. */
function besides(rect: Rect, cover: Rect): readonly Rect[] {
  const [right, bottom] = [rect.left + rect.width, rect.top + rect.height];
  const [x0, x1] = [Math.max(rect.left, cover.left), Math.min(right, cover.left + cover.width)];
  const [y0, y1] = [Math.max(rect.top, cover.top), Math.min(bottom, cover.top + cover.height)];
  if (x0 >= x1 || y0 >= y1) return [rect];
  return [
    { ...rect, width: x0 - rect.left },
    { ...rect, left: x1, width: right - x1 },
    { ...rect, height: y0 - rect.top },
    { ...rect, top: y1, height: bottom - y1 },
  ].filter(({ width, height }) => width >= 1 && height >= 1);
}

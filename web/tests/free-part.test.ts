import { expect, test } from 'vitest';
import { ASPECT, type Part, type Rect } from '../src/scene/drawn';
import { fieldOf, freePart, freeSize, WHOLE } from '../src/scene/free-part';
import { Lens } from '../src/scene/lens';

const PICTURES: readonly Rect[] = [
  { left: 6, top: 40, width: 830, height: 208 },
  { left: 0, top: 0, width: 366, height: 480 },
  { left: 3, top: 90, width: 1000, height: 340 },
];
/** Places and sizes of a picture over another, as parts of its size. */
const SHARES = [-0.2, 0, 0.3, 0.55, 0.8, 1.1] as const;
const SIZES = [0.2, 0.45, 0.7] as const;

function over(rect: Rect): readonly Rect[] {
  return SHARES.flatMap((x) =>
    SHARES.flatMap((y) =>
      SIZES.map((size) => ({
        left: rect.left + x * rect.width,
        top: rect.top + y * rect.height,
        width: size * rect.width,
        height: size * rect.height,
      })),
    ),
  );
}

test.each(PICTURES)('the free part of a picture is inside it, and no other picture covers it: %o', (rect) => {
  for (const cover of over(rect)) {
    const free = freePart(rect, [cover]);
    const { width, height } = freeSize({ rect, free });
    const [left, top] = [rect.left + free.left * rect.width, rect.top + free.top * rect.height];
    expect(Math.min(free.left, free.top)).toBeGreaterThanOrEqual(0);
    expect(Math.max(free.left + free.width, free.top + free.height)).toBeLessThanOrEqual(1 + 1e-9);
    const wide = Math.min(left + width, cover.left + cover.width) - Math.max(left, cover.left);
    const high = Math.min(top + height, cover.top + cover.height) - Math.max(top, cover.top);
    expect(Math.min(wide, high)).toBeLessThanOrEqual(1e-9);
  }
});

test('a picture that no other covers is free as a whole', () => {
  for (const rect of PICTURES) {
    expect(freePart(rect, [])).toEqual(WHOLE);
    expect(freePart(rect, [{ ...rect, left: rect.left + rect.width }])).toEqual(WHOLE);
  }
});

test('beside a picture in the corner, the strip is free in which the field of view is largest', () => {
  const low = { left: 0, top: 0, width: 800, height: 200 };
  expect(freePart(low, [{ left: 420, top: 0, width: 380, height: 95 }])).toEqual({ ...WHOLE, width: 0.525 });
  const high = { left: 0, top: 0, width: 360, height: 480 };
  const below = freePart(high, [{ left: 195, top: 0, width: 165, height: 215 }]);
  expect(below).toEqual({ ...WHOLE, top: 215 / 480, height: 265 / 480 });
});

const PARTS: readonly Part[] = [
  WHOLE,
  { left: 0, top: 0, width: 0.52, height: 1 },
  { left: 0, top: 0.45, width: 1, height: 0.55 },
  { left: 0.3, top: 0.1, width: 0.4, height: 0.2 },
];

test.each(PARTS)('a lens has the middle and the edges of its field in the free part: %o', (free) => {
  for (const angle of [0.2, 0.8, 1.6])
    for (const aspect of [0.7, 1.2, ASPECT, 4]) {
      const lens = new Lens(0.01, 100);
      lens.angle = angle;
      lens.fit(aspect, free);
      const { elements: e } = lens.projectionMatrix;
      /** Place in the picture of a point at a distance of 1. */
      const at = (x: number, y: number) => ({
        x: (1 + (e[0] ?? 0) * x - (e[8] ?? 0)) / 2,
        y: (1 - (e[5] ?? 0) * y + (e[9] ?? 0)) / 2,
      });
      const middle = at(0, 0);
      expect(middle.x).toBeCloseTo(free.left + free.width / 2, 9);
      expect(middle.y).toBeCloseTo(free.top + free.height / 2, 9);
      const field = fieldOf({ width: aspect * free.width, height: free.height });
      const half = Math.tan(angle / 2);
      expect((at(half, 0).x - middle.x) * 2 * aspect).toBeCloseTo(field, 6);
      expect((middle.y - at(0, half).y) * 2).toBeCloseTo(field, 6);
    }
});

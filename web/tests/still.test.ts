import { describe, expect, it, test } from 'vitest';
import { Still } from '../src/cameras/still';
import { parts, uncovered } from '../src/cameras/tiles';
import type { Piece, Rect, View } from '../src/scene/drawn';
import { areaOf } from '../src/scene/drawn';
import { WHOLE as ALL } from '../src/scene/free-part';
import { SAMPLES } from '../src/scene/samples';

const rect = (left: number, top: number, width: number, height: number): Rect => ({
  left,
  top,
  width,
  height,
});
const view = (camera: string, at: Rect): View => ({ camera, rect: at, free: ALL, early: false });
const area = ({ width, height }: Rect) => width * height;

/** How many of the rectangles contain the middle of each px of a grid. */
function counts(rects: readonly Rect[], within: Rect): readonly number[] {
  const found: number[] = [];
  for (let y = 0; y < within.height; y += 1)
    for (let x = 0; x < within.width; x += 1) {
      const [px, py] = [within.left + x + 0.5, within.top + y + 0.5];
      found.push(
        rects.filter(
          ({ left, top, width, height }) => px > left && px < left + width && py > top && py < top + height,
        ).length,
      );
    }
  return found;
}

const WHOLE = rect(10, 20, 60, 40);
const OTHERS: readonly (readonly [string, Rect])[] = [
  ['in a corner', rect(45, 20, 25, 15)],
  ['in the middle', rect(30, 30, 10, 10)],
  ['across', rect(0, 30, 100, 5)],
  ['over it all', rect(0, 0, 100, 100)],
  ['beside it', rect(70, 20, 20, 40)],
];

test.each(OTHERS)('the parts that another rectangle %s leaves cover the rest once', (_, other) => {
  const left = uncovered(WHOLE, [other]);
  const covered = counts([other], WHOLE);
  expect(counts(left, WHOLE)).toEqual(covered.map((hidden) => 1 - hidden));
});

test.each([1, 37, 100, 599, 2400, 1e9])('rows of at most %d px cover a rectangle once', (most) => {
  const rows = parts(WHOLE, most);
  expect(counts(rows, WHOLE).every((count) => count === 1)).toBe(true);
  expect(rows.every((row) => area(row) <= Math.max(most, WHOLE.width) || row.height === 1)).toBe(true);
});

test.each([1, 1.25, 1.5, 2])('rows meet without a gap in pixels of the screen: %d a px', (ratio) => {
  const odd = { left: 7.5, top: 43.390625, width: 633.25, height: 367.71875 };
  const areas = parts(odd, 10_000).map((row) => areaOf(row, 800, ratio));
  const whole = areaOf(odd, 800, ratio);
  expect(areas.reduce((sum, { height }) => sum + height, 0)).toBe(whole.height);
  areas.slice(1).forEach(({ y, height }, i) => {
    expect(y + height).toBe(areas[i]?.y);
  });
});

describe('still pictures', () => {
  const views = [view('A', rect(0, 0, 40, 30)), view('B', rect(50, 0, 40, 30))];

  /** Draws all pieces, and returns them turn by turn. */
  function turns(still: Still, most: number, key = 'a'): Piece[][] {
    const found = [];
    do found.push([...still.next(key, views, most)]);
    while (!still.done && found.length < 1e4);
    return found;
  }

  it.each([1, 500, 1000, 2500, 1e9])(
    'are drawn with each sample everywhere once, at most %d px a turn',
    (most) => {
      const all = turns(new Still(), most).flat();
      for (const { camera, rect: whole } of views)
        SAMPLES.forEach((_, sample) => {
          const own = all.filter((piece) => piece.view.camera === camera && piece.sample === sample);
          expect(
            counts(
              own.map(({ part }) => part),
              whole,
            ).every((count) => count === 1),
          ).toBe(true);
        });
    },
  );

  it.each([500, 1000, 2500])('have turns of at most %d px', (most) => {
    for (const turn of turns(new Still(), most))
      expect(turn.reduce((sum, { part }) => sum + area(part), 0)).toBeLessThanOrEqual(most);
  });

  it('have all parts of a sample before the next sample', () => {
    const samples = turns(new Still(), 300).flatMap((turn) => turn.map(({ sample }) => sample));
    expect(samples).toEqual([...samples].sort((a, b) => a - b));
  });

  it('are drawn once, and again when something in them changes', () => {
    const still = new Still();
    const first = turns(still, 1000).flat().length;
    expect(still.next('a', views, 1000)).toEqual([]);
    expect(turns(still, 1000, 'b').flat().length).toBe(first);
    still.forget();
    expect(turns(still, 1000, 'b').flat().length).toBe(first);
  });

  it('begin again if something changes before they are complete', () => {
    const still = new Still();
    still.next('a', views, 500);
    still.next('a', views, 500);
    expect(still.next('b', views, 500)[0]?.sample).toBe(0);
  });
});

test('the samples lie in the pixel, and their mean is its middle', () => {
  for (const axis of [0, 1] as const) {
    const places = SAMPLES.map((sample) => sample[axis]);
    expect(Math.max(...places.map(Math.abs))).toBeLessThan(0.5);
    expect(places.reduce((sum, place) => sum + place, 0)).toBe(0);
    expect(new Set(places).size).toBe(SAMPLES.length);
  }
});

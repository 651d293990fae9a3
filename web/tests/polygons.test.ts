import { afterEach, beforeEach, describe, expect, it, test, vi } from 'vitest';
import { PolygonPictures } from '../src/link/polygon-pictures';
import type { FreeEye, Polygons } from '../src/link/protocol';
import type { Command } from '../src/link/socket';
import { drawPolygons, type Pen } from '../src/panel/monitors/polygon-pane';

const base64 = (array: Uint8Array) => btoa(String.fromCharCode(...array));

/** A picture with these polygons: the grey of each, and its corners in fractions of half the picture's width. */
function picture(
  ...polygons: readonly (readonly [number, readonly (readonly [number, number])[]])[]
): Polygons {
  const corners = polygons.flatMap(([, places]) => places.flat()).map((at) => Math.round(10_000 * at));
  return {
    ...{ type: 'polygons', step: 1, camera: 'A', text: '', share: null },
    points: base64(new Uint8Array(Int16Array.from(corners).buffer)),
    corners: base64(Uint8Array.from(polygons, ([, { length }]) => length)),
    greys: base64(Uint8Array.from(polygons, ([grey]) => grey)),
  };
}

/** Draws a picture of 200 by 100 px; returns what was filled: the colour, and the corners of each path. */
function drawn(of: Polygons): readonly string[] {
  const done: string[] = [];
  let path: string[] = [];
  const pen = {
    ...{ fillStyle: '', strokeStyle: '', lineWidth: 0, lineJoin: 'miter' as CanvasLineJoin },
    beginPath() {
      path = [];
    },
    moveTo: (x: number, y: number) => path.push(`M${x} ${y}`),
    lineTo: (x: number, y: number) => path.push(`L${x} ${y}`),
    closePath: () => path.push('Z'),
    fill: () => done.push(`${pen.fillStyle}: ${path.join('')}`),
    stroke: () => expect(pen.strokeStyle).toBe(pen.fillStyle),
    fillRect: (...sides: number[]) => done.push(`${pen.fillStyle}: ${sides.join(' ')}`),
  };
  drawPolygons(pen as unknown as Pen, of, { width: 200, height: 100 });
  return done;
}

const [TRIANGLE, OTHER] = [
  [
    [-1, -0.5],
    [1, -0.5],
    [0, 0.25],
  ],
  [
    [0, 0],
    [0.5, 0],
    [0, 0.5],
  ],
] as const;
const [FIRST, SECOND] = ['M0 0L200 0L100 75Z', 'M100 50L150 50L100 100Z'];

describe('a picture in the look of 1972', () => {
  it('is painted on black in the order of its polygons, under raster lines at every third pixel', () => {
    const [back, first, second, ...raster] = drawn(picture([64, TRIANGLE], [255, OTHER]));
    expect(back).toBe('#000: 0 0 200 100');
    expect(first).toBe(`rgb(64 64 64): ${FIRST}`);
    expect(second).toBe(`rgb(255 255 255): ${SECOND}`);
    expect(raster).toEqual(Array.from({ length: 34 }, (_, k) => `rgb(0 0 0 / 45%): 0 ${3 * k} 200 1`));
  });

  it('has one path for polygons of one grey that follow each other', () => {
    const polygons = drawn(picture([64, TRIANGLE], [64, OTHER], [32, OTHER], [64, TRIANGLE])).slice(1, 4);
    expect(polygons).toEqual([
      `rgb(64 64 64): ${FIRST}${SECOND}`,
      `rgb(32 32 32): ${SECOND}`,
      `rgb(64 64 64): ${FIRST}`,
    ]);
  });

  it('is black without polygons', () => {
    expect(drawn(picture()).length).toBe(1 + 34);
  });
});

let hide: () => void;

beforeEach(() => {
  vi.stubGlobal('document', {
    hidden: true,
    addEventListener: (_: string, listener: () => void) => {
      hide = listener;
    },
  });
});

afterEach(() => {
  vi.unstubAllGlobals();
});

function made() {
  const sent: Command[] = [];
  const pictures = new PolygonPictures((command) => sent.push(command));
  const put = (camera: string, step: number) => pictures.put({ ...picture(), camera, step });
  return { sent, pictures, put };
}

const one = (camera: string, aspect: number, eye: FreeEye | null = null) => ({ camera, aspect, eye });
const asks = (...pictures: ReturnType<typeof one>[]) => ({ type: 'show_polygons', pictures });

test('a page asks for its pictures once, for each camera with the aspect of the highest picture', () => {
  const { sent, pictures } = made();
  pictures.want([]);
  expect(sent).toEqual([]);
  const shown = [one('A', 1.38), one('B', 9), one('A', 0.69), one('C', 0.1)];
  pictures.want(shown);
  pictures.want([...shown]);
  expect(sent).toEqual([asks(one('A', 0.6), one('B', 4), one('C', 0.5))]);
  pictures.want([]);
  expect(sent[1]).toEqual(asks());
});

test('a page asks again after a new connection, and for nothing while it is hidden', () => {
  const { sent, pictures } = made();
  const shown = [one('A', 1.5)];
  pictures.want(shown);
  pictures.askAgain();
  pictures.want(shown);
  hide();
  pictures.want(shown);
  const asked = asks(one('A', 1.5));
  expect(sent).toEqual([asked, asked, asks(), asked]);
});

test('a step has the newest picture that is not newer than the step', () => {
  const { pictures, put } = made();
  expect(pictures.at('A', 5)).toBe(null);
  for (const step of [3, 5, 7]) put('A', step);
  put('B', 6);
  expect([2, 4, 5, 6, 9].map((step) => pictures.at('A', step)?.step)).toEqual([3, 3, 5, 5, 7]);
  expect(pictures.at('B', 5)?.step).toBe(6);
});

test('another session removes the pictures of the one before', () => {
  const { pictures, put } = made();
  for (const step of [90, 91, 1]) put('A', step);
  expect(pictures.at('A', 91)?.step).toBe(1);
});

test('a camera that is not shown any more has no old picture when it is shown again', () => {
  const { pictures, put } = made();
  pictures.want([one('A', 1)]);
  put('A', 3);
  pictures.want([]);
  expect(pictures.at('A', 5)).toBe(null);
});

test('a page asks again when the eye of its engineering view moves', () => {
  const { sent, pictures } = made();
  const eye = (x: number): FreeEye => ({
    ...{ position: [x, 0, 0], ahead: [0, 0, 1], up: [0, -1, 0] },
    field_of_view: 1,
  });
  for (const x of [1, 1, 2]) pictures.want([one('ENG', 1.5, eye(x))]);
  expect(sent).toEqual([1, 2].map((x) => asks(one('ENG', 1.5, eye(x)))));
});

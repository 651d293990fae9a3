import { afterEach, beforeEach, describe, expect, it, test, vi } from 'vitest';
import type { Monitors } from '../src/cameras/monitors';
import { PACES, type Pane, Panes } from '../src/cameras/panes';
import type { Camera } from '../src/link/protocol';
import type { Matrix } from '../src/panel/monitors/matrix';
import type { Quality } from '../src/scene/drawn';

let narrow: boolean;

beforeEach(() => {
  narrow = false;
  vi.stubGlobal('matchMedia', () => ({ matches: narrow }));
});

afterEach(() => {
  vi.unstubAllGlobals();
});

const camera = (name: string) => ({ name }) as Camera;

/** An element at a position on the page. */
function box(left: number, top: number, width: number, height: number) {
  const element = {
    ...{ clientWidth: width, clientHeight: height, isConnected: true },
    getBoundingClientRect: () => ({ left, top, width, height }),
  };
  return element as typeof element & HTMLElement;
}

/** A page with MON 1 (split: A, B), MON 2 (C) and two tiles (A, B). */
function page(quality: Quality = 'low') {
  const picture = (name: string) => ({ camera: camera(name), element: box(0, 0, 100, 80) });
  const [first, second] = [box(0, 0, 200, 100), box(0, 0, 200, 100)];
  const both = [
    { element: first, pictures: [picture('A'), picture('B')] },
    { element: second, pictures: [picture('C')] },
  ];
  const tiles = ['A', 'B'].map((name) => ({ camera: camera(name), picture: box(0, 0, 50, 40) }));
  const canvas = box(10, 20, 800, 600);
  const panes = new Panes(
    canvas as unknown as HTMLCanvasElement,
    { both } as unknown as Monitors,
    { tiles } as unknown as Matrix,
    quality,
  );
  return { first, second, both, tiles, canvas, panes };
}

const names = (all: readonly Pane[]) => all.map((pane) => pane.camera.name).join('');
const paces = (all: readonly Pane[]) => all.map(({ pace }) => pace);

describe('pictures on the page', () => {
  it.each<Quality>(['full', 'low'])(
    'are on monitors, and drawn at each drawing of the page: %s',
    (quality) => {
      const { panes, both } = page(quality);
      const all = panes.all(false);
      expect(names(all)).toBe('ABC');
      expect(paces(all)).toEqual([1, 1, 1]);
      expect(all.map(({ picture }) => picture)).toEqual(both.flatMap(({ pictures }) => pictures));
    },
  );

  it.each<Quality>(['full', 'low'])('are the tiles while all cameras are shown: %s', (quality) => {
    const { panes, tiles } = page(quality);
    const all = panes.all(true);
    expect(all.map(({ element }) => element)).toEqual(tiles.map(({ picture }) => picture));
    expect(all.every(({ pace, picture }) => pace === PACES[quality].tile && picture === null)).toBe(true);
  });

  it('exclude a monitor in a secondary window', () => {
    const { first, panes } = page();
    first.isConnected = false;
    const all = panes.all(false);
    expect(names(all)).toBe('C');
  });

  it('have the look of 1972 if their monitor has it, and as tiles if the view of all cameras has it', () => {
    const { panes } = page();
    expect(panes.all(false, [true, false]).map(({ polygons }) => polygons)).toEqual([true, true, false]);
    expect(panes.all(true, [true, true, false]).some(({ polygons }) => polygons)).toBe(false);
    expect(panes.all(true, [false, false, true]).every(({ polygons }) => polygons)).toBe(true);
  });
});

/** Draws pictures; `stops` is the exposure of each camera. */
function drawn(open = false, both = true) {
  const { panes, second } = page();
  second.isConnected = both;
  const all = panes.all(open);
  const stops: Record<string, number> = {};
  const draw = (state: string, count: number, wiped = false) => {
    const { due, complete } = panes.due(all, state, (name) => stops[name] ?? 0, open, count, wiped);
    return `${names(due)} ${complete}`;
  };
  return { stops, draw };
}

describe('a picture', () => {
  it('is drawn once for each state', () => {
    const { draw } = drawn();
    expect([draw('1', 0), draw('1', 1), draw('1', 2)]).toEqual(['ABC true', ' true', ' true']);
    expect(draw('2', 4)).toBe('ABC true');
  });

  it('is drawn again when its exposure changes; other pictures are not', () => {
    const { stops, draw } = drawn();
    draw('1', 0);
    stops['B'] = 0.5;
    expect(draw('1', 2)).toBe('B true');
  });

  it('is drawn together with the picture in its corner', () => {
    narrow = true;
    const { stops, draw } = drawn();
    draw('1', 0);
    stops['C'] = 0.5;
    expect(draw('1', 1)).toBe('ABC true');
  });

  it('is drawn alone if the other monitor has a secondary window', () => {
    narrow = true;
    const { stops, draw } = drawn(false, false);
    draw('1', 0);
    stops['B'] = 0.5;
    expect(draw('1', 1)).toBe('B true');
  });

  it('in the view of all cameras is drawn at its own turn', () => {
    narrow = true;
    const { stops, draw } = drawn(true);
    expect([0, 1, 2, 3, 4].map((count) => draw('1', count))).toEqual([
      'A false',
      ' false',
      ' false',
      ' false',
      ' false',
    ]);
    expect(draw('1', 5)).toBe('B true');
    stops['B'] = 0.5;
    expect(draw('1', 11)).toBe('B true');
  });

  it('is always drawn again after the canvas was wiped', () => {
    const { draw } = drawn();
    draw('1', 0);
    expect(draw('1', 1, true)).toBe('ABC true');
    expect(draw('1', 3)).toBe(' true');
  });
});

type Page = ReturnType<typeof page>;

test.each<[string, (page: Page) => void]>([
  ['a picture', ({ both }) => Object.assign(both[1]?.pictures[0]?.element ?? {}, { clientWidth: 90 })],
  ['the width of the canvas', ({ canvas }) => Object.assign(canvas, { clientWidth: 700 })],
  ['the height of the canvas', ({ canvas }) => Object.assign(canvas, { clientHeight: 500 })],
  ['the number of monitors', ({ second }) => Object.assign(second, { isConnected: false })],
])('the layout changes once with %s', (_, change) => {
  const changed = page();
  const { panes } = changed;
  const take = () => panes.takeLayout(panes.all(false), false);
  expect([take(), take()]).toEqual([true, false]);
  change(changed);
  expect(panes.isLaidOut(panes.all(false), false)).toBe(false);
  expect([take(), take()]).toEqual([true, false]);
  expect(panes.isLaidOut(panes.all(false), false)).toBe(true);
});

test('the layout changes when all cameras are shown, even if all positions are equal', () => {
  const { panes } = page();
  panes.takeLayout(panes.all(false), false);
  expect(panes.takeLayout(panes.all(false), true)).toBe(true);
});

test('positions are measured from the corner of the canvas', () => {
  const { panes } = page();
  expect(panes.rectOf(box(110, 220, 30, 40))).toEqual({ left: 100, top: 200, width: 30, height: 40 });
});

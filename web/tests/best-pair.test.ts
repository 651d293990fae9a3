import { expect, test } from 'vitest';
import {
  bestPair,
  between,
  clarity,
  type Need,
  type Places,
  type Sighting,
  type Subject,
  score,
  suffices,
} from '../src/cameras/best-pair';
import type { Vec3 } from '../src/link/protocol';
import { degree } from './camera-values';

const at: Places = { tip: [0, 0, 0], payload: [1, 0, 0], target: null, gap: [0, 0, 0] };
const needs: readonly Need[] = [['tip'], ['payload']];

type Shows = Partial<Record<Subject, number>>;

function sighting(camera: string, lens: Vec3, shows: Shows, more: Partial<Sighting> = {}): Sighting {
  const all = { tip: 0, payload: 0, target: 0, gap: 0, ...shows };
  return { camera, lens, shows: all, turned: 0, kind: 'camera', onArm: false, ...more };
}

function names(...sightings: readonly Sighting[]): readonly string[] | undefined {
  return bestPair(sightings, at, needs)
    ?.cameras.map(({ camera }) => camera)
    .sort();
}

const [aft, side]: readonly Vec3[] = [
  [10, 0, 0],
  [0, 10, 0],
];
const both: Shows = { tip: 1, payload: 1 };

test('two lines of sight are at most 90° apart', () => {
  expect(between([1, 0, 0], [0, 1, 0], [0, 0, 0]) / degree).toBeCloseTo(90);
  expect(between([1, 0, 0], [-1, 0, 0], [0, 0, 0]) / degree).toBeCloseTo(0);
  expect(between([1, 0, 0], [-1, 1, 0], [0, 0, 0]) / degree).toBeCloseTo(45);
});

test('a subject is clearer if more of it is visible, if it is larger, and if it has light without glare', () => {
  const seen = { visible: 1, size: 0.04, light: 0.5, glare: false };
  const least = clarity(seen);
  for (const worse of [{ visible: 0.5 }, { size: 0.01 }, { light: 0 }, { glare: true }])
    expect(clarity({ ...seen, ...worse })).toBeLessThan(least);
  expect(clarity({ ...seen, light: 0 })).toBeGreaterThan(0);
  expect(clarity({ ...seen, visible: 0 })).toBe(0);
  expect(clarity({ ...seen, size: 40 })).toBeLessThan(clarity({ ...seen, size: 1 }));
});

test('no pair without two cameras that show a subject', () => {
  expect(bestPair([sighting('A', [10, 0, 0], both), sighting('B', [0, 10, 0], {})], at, needs)).toBeNull();
  expect(bestPair([], at, needs)).toBeNull();
});

test('a picture turned by more than 100° is chosen only if no other picture shows a subject', () => {
  const [a, b] = [sighting('A', [10, 0, 0], both), sighting('B', [0, 10, 0], { gap: 0.1 })];
  const turned = sighting('C', [0, 10, 0], { ...both, gap: 1 }, { turned: 101 * degree });
  expect(names(a, b, turned)).toEqual(['A', 'B']);
  expect(names(a, turned)).toEqual(['A', 'C']);
  const straightDown = { ...turned, turned: 99 * degree };
  expect(names(a, b, straightDown)).toEqual(['A', 'C']);
});

test('a pair that shows both hand and payload is preferred to any that leaves one out', () => {
  const [a, b] = [
    sighting('A', [10, 0, 0], { payload: 1, gap: 1 }),
    sighting('B', [0, 10, 0], { payload: 1, gap: 1 }),
  ];
  const free = sighting('ENG', [0, 10, 0], { tip: 0.2 }, { kind: 'engineering' });
  expect(names(a, b)).toEqual(['A', 'B']);
  expect(names(a, b, free)).toContain('ENG');
  const pair = bestPair([a, b], at, needs);
  expect(pair && suffices(pair, needs)).toBe(false);
  expect(pair && suffices(pair, [['tip', 'payload']])).toBe(true);
});

test('a television camera is preferred to a window, and a window to the engineering view', () => {
  const a = sighting('A', [10, 0, 0], both);
  const [tv, pane, free] = (['camera', 'window', 'engineering'] as const).map((kind) =>
    sighting(kind, [0, 10, 0], both, { kind }),
  ) as [Sighting, Sighting, Sighting];
  expect(names(a, free, pane, tv)).toEqual(['A', 'camera']);
  expect(names(a, free, pane)).toEqual(['A', 'window']);
});

test('the score is symmetric, and rises with clarity and with the angle between the lines of sight', () => {
  const [a, b] = [sighting('A', aft ?? [0, 0, 0], both), sighting('B', side ?? [0, 0, 0], { tip: 0.5 })];
  expect(score(a, b, at)).toBe(score(b, a, at));
  expect(score(a, { ...b, shows: { ...b.shows, tip: 0.6 } }, at)).toBeGreaterThan(score(a, b, at));
  expect(score(a, { ...b, lens: [10, 3, 0] }, at)).toBeLessThan(score(a, b, at));
  expect(score(a, { ...b, turned: 1 }, at)).toBeLessThan(score(a, b, at));
  expect(score(a, { ...b, onArm: true }, at)).toBeLessThan(score(a, b, at));
});

test('of equal pairs the first is chosen, and the picture that is turned least comes first', () => {
  const [a, b, c] = ['A', 'B', 'C'].map((name) => sighting(name, [10, 0, 0], both)) as [
    Sighting,
    Sighting,
    Sighting,
  ];
  expect(names(a, b, c)).toEqual(['A', 'B']);
  const pair = bestPair(
    [
      { ...a, turned: 0.5 },
      { ...b, turned: 0.2 },
    ],
    at,
    needs,
  );
  expect(pair?.cameras.map(({ camera }) => camera)).toEqual(['B', 'A']);
  expect(pair?.both).toEqual(['tip', 'payload']);
});

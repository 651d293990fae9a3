import { expect, test } from 'vitest';
import { bestPair, between, type Sighting, type Target } from '../src/cameras/best-pair';
import type { Vec3 } from '../src/link/protocol';
import { degree } from './camera-values';

test('two lines of sight are at most 90° apart', () => {
  expect(between([1, 0, 0], [0, 1, 0], [0, 0, 0]) / degree).toBeCloseTo(90);
  expect(between([1, 0, 0], [-1, 0, 0], [0, 0, 0]) / degree).toBeCloseTo(0);
  expect(between([1, 0, 0], [-1, 1, 0], [0, 0, 0]) / degree).toBeCloseTo(45);
});

function sighting(camera: string, lens: Vec3, sees: readonly Target[], turned = 0): Sighting {
  return { camera, lens, sees: new Set(sees), turned };
}

test('the best pair sees the clearance from the most different directions', () => {
  const at = { gap: [0, 0, 0], tip: [1, 0, 0], payload: [2, 0, 0] } as const;
  const [a, b, c] = [
    sighting('A', [10, 0, 0], ['gap', 'tip']),
    sighting('B', [10, 2, 0], ['gap']),
    sighting('C', [9, 6, 0], ['gap'], 0.4),
  ];
  const square = sighting('D', [0, 10, 0], ['tip', 'payload']);
  const names = (sightings: readonly Sighting[]) =>
    bestPair(sightings, at)?.cameras.map(({ camera }) => camera);
  expect(names([a, b, c, square])).toEqual(['A', 'C']);
  expect(bestPair([a, b, c, square], at)?.targets).toEqual(['gap']);
  expect(bestPair([a, b, c], at)?.apart).toBeCloseTo(Math.atan2(6, 9));
  // If no two cameras see the gap, the pair sees tip and payload, or else the tip.
  const two = sighting('E', [5, 5, 0], ['tip', 'payload']);
  expect(bestPair([a, square, two], at)?.targets).toEqual(['tip', 'payload']);
  expect(bestPair([a, square], at)?.targets).toEqual(['tip']);
  expect(bestPair([a], at)).toBeNull();
  expect(bestPair([a, b], { ...at, gap: null })).toBeNull();
});

test('among pairs with angles near 90°, the pair whose pictures are turned least is best', () => {
  const at = { gap: [0, 0, 0], tip: null, payload: null } as const;
  const angle = (degrees: number): Vec3 => [Math.cos(degrees * degree), Math.sin(degrees * degree), 0];
  const pair = bestPair(
    [
      sighting('A', angle(0), ['gap']),
      sighting('B', angle(90), ['gap'], 3),
      sighting('C', angle(75), ['gap'], 0.2),
    ],
    at,
  );
  expect(pair?.cameras.map(({ camera }) => camera)).toEqual(['A', 'C']);
});

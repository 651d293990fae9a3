import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { Polygons } from '../src/link/protocol';
import { RecordedPolygons } from '../src/replay/recorded-polygons';

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

const picture = (camera: string, step: number): Polygons => ({
  ...{ type: 'polygons', camera, step },
  ...{ points: '', corners: '', greys: '', text: '', share: null },
});
const one = (camera: string) => ({ camera, aspect: 1.5, eye: null });

/** A replay whose server answers when `answer` is called. */
function made() {
  const asked: string[] = [];
  const waiting: ((pictures: readonly Polygons[]) => void)[] = [];
  const polygons = new RecordedPolygons((tick, pictures) => {
    asked.push(`${tick} ${pictures.map(({ camera }) => camera).join('')}`);
    return new Promise((done) => waiting.push(done));
  });
  const answer = async (...pictures: readonly Polygons[]) => {
    waiting.shift()?.(pictures);
    await vi.advanceTimersByTimeAsync(0);
  };
  return { asked, polygons, answer };
}

test('a replay asks once for the pictures of a frame, and next for those of the newest frame', async () => {
  const { asked, polygons, answer } = made();
  polygons.want([one('A'), one('B')]);
  for (const tick of [5, 5, 6, 7]) expect(polygons.at('A', tick)).toBe(null);
  expect(asked).toEqual(['5 AB']);
  await answer(picture('A', 5), picture('B', 5));
  expect(asked).toEqual(['5 AB', '7 AB']);
  expect(polygons.at('B', 7)?.step).toBe(5);
  await answer(picture('A', 7), picture('B', 7));
  expect(polygons.at('A', 7)?.step).toBe(7);
  expect(asked.length).toBe(2);
  expect(polygons.received).toBe(2);
});

test('a replay asks again while the look is being prepared', async () => {
  const { asked, polygons, answer } = made();
  polygons.want([one('A')]);
  polygons.at('A', 5);
  await answer(picture('A', -1));
  expect(asked.length).toBe(1);
  await vi.advanceTimersByTimeAsync(1000);
  expect(asked).toEqual(['5 A', '5 A']);
});

test('a replay without pictures of 1972 asks for none, and forgets those it had', async () => {
  const { asked, polygons, answer } = made();
  polygons.want([]);
  polygons.at('A', 5);
  expect(asked).toEqual([]);
  polygons.want([one('A')]);
  polygons.at('A', 5);
  await answer(picture('A', 5));
  polygons.want([]);
  expect(polygons.at('A', 5)).toBe(null);
});

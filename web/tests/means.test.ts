import { expect, test } from 'vitest';
import { Means } from '../src/scene/means';

const AREA = { x: 2, y: 1, width: 3, height: 2 };
const fill = (value: number) => new Uint8Array(4 * AREA.width * AREA.height).fill(value);

function read(means: Means, count: number): readonly number[] {
  const to = new Uint8ClampedArray(4 * AREA.width * AREA.height);
  means.read(to, AREA, count);
  return [...to];
}

test('the mean of samples is shown', () => {
  const means = new Means();
  means.resize(8, 6);
  [10, 20, 60].forEach((value, sample) => {
    means.add(fill(value), AREA, sample);
  });
  expect(new Set(read(means, 3))).toEqual(new Set([30]));
});

test('many samples of white are white', () => {
  const means = new Means();
  means.resize(8, 6);
  for (let sample = 0; sample < 8; sample += 1) means.add(fill(255), AREA, sample);
  expect(new Set(read(means, 8))).toEqual(new Set([255]));
});

test('the first sample begins a new picture', () => {
  const means = new Means();
  means.resize(8, 6);
  means.add(fill(200), AREA, 0);
  means.add(fill(50), AREA, 0);
  expect(new Set(read(means, 1))).toEqual(new Set([50]));
});

test('rows are from the bottom in WebGL, and from the top on the page', () => {
  const means = new Means();
  means.resize(8, 6);
  const bytes = fill(1);
  bytes.fill(9, 0, 4 * AREA.width); // the lowest row
  means.add(bytes, AREA, 0);
  const line = 4 * AREA.width;
  expect(read(means, 1)).toEqual([...Array(line).fill(1), ...Array(line).fill(9)]);
});

test('parts of the canvas are independent', () => {
  const means = new Means();
  means.resize(8, 6);
  means.add(fill(100), AREA, 0);
  means.add(fill(7), { ...AREA, x: AREA.x + AREA.width }, 0);
  means.add(fill(7), { ...AREA, y: AREA.y + AREA.height }, 0);
  expect(new Set(read(means, 1))).toEqual(new Set([100]));
});

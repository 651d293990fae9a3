import { expect, test } from 'vitest';
import { clipped, labelPlace } from '../src/panel/monitors/label-place';

const BOX = { left: 0, top: 0, right: 100, bottom: 80 };

test('a line is clipped at the edges of the picture', () => {
  expect(clipped({ x: -50, y: 40 }, { x: 50, y: 40 }, BOX)).toEqual([
    { x: 0, y: 40 },
    { x: 50, y: 40 },
  ]);
  expect(clipped({ x: 10, y: -5 }, { x: 90, y: -1 }, BOX)).toBeNull();
  expect(clipped({ x: -30, y: 70 }, { x: 30, y: 130 }, BOX)).toBeNull();
  expect(clipped({ x: 10, y: 10 }, { x: 10, y: 10 }, BOX)).not.toBeNull();
});

test('a label is placed away from the centre and covers nothing', () => {
  const picture = { width: 600, height: 400 };
  const label = { width: 60, height: 20 };
  const at = (x: number, y: number, taken: (typeof BOX)[] = []) =>
    labelPlace(
      [
        { x, y },
        { x: x + 20, y },
      ],
      label,
      picture,
      taken,
    );
  expect(at(200, 200).x + label.width).toBeLessThan(200);
  expect(at(400, 200).x).toBeGreaterThan(420);
  expect(at(10, 200).x).toBeGreaterThan(30);
  const beside = { left: 100, top: 150, right: 199, bottom: 250 };
  expect(at(200, 200, [beside]).x).toBeGreaterThan(220);
  const corner = { left: 480, top: 370, right: 600, bottom: 400 };
  const { x: left, y: top } = at(575, 385, [corner]);
  expect(left < 480 - label.width || top <= 370 - label.height).toBe(true);
  for (const x of [-10, 0, 300, 590, 620]) {
    const { x: left, y: top } = at(x, 2);
    expect(left >= 0 && top >= 0 && left + label.width <= 600 && top + label.height <= 400).toBe(true);
  }
});

test('a label at a slanted line is 12 px from it', () => {
  const label = { width: 40, height: 20 };
  const [a, b] = [
    { x: 300, y: 100 },
    { x: 500, y: 200 },
  ];
  const { x, y } = labelPlace([a, b], label, { width: 600, height: 400 }, []);
  const corners = [x, x + label.width].flatMap((u) => [y, y + label.height].map((v) => ({ u, v })));
  const off = corners.map(({ u, v }) => (100 * (u - a.x) - 200 * (v - a.y)) / Math.hypot(200, 100));
  expect(Math.min(...off.map(Math.abs))).toBeCloseTo(12, 6);
  expect(new Set(off.map(Math.sign)).size).toBe(1);
});

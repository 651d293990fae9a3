import { expect, test } from 'vitest';
import type { BodyInfo, Camera, Shape, Vec3 } from '../src/link/protocol';
import { Body } from '../src/scene/bodies';
import { Cameras } from '../src/scene/cameras';
import { LambertLight } from '../src/scene/lambert';
import { Materials } from '../src/scene/materials';
import { Sight } from '../src/scene/sight';
import { bay, degree, near } from './camera-values';

const placed = { position: [0, 0, 0], rotation: [0, 0, 0] } as const;

function body(name: string, at: Vec3, size: Vec3 = [1, 1, 1]): Body {
  const box: Shape = { ...placed, kind: 'box', material: 'metal', size };
  const info: BodyInfo = { name, shapes: [box], details: [] };
  const made = new Body(info, new Materials('low', new LambertLight(0)), 'low');
  made.setPose([...at, 1, 0, 0, 0], 0);
  return made;
}

function place(...others: Body[]): { sight: Sight; cameras: Cameras } {
  const bodies = [body('place', [0, 0, -50]), ...others];
  const cameras = new Cameras(
    [
      { ...bay, position: [0, 0, 50] },
      { ...eye, position: [0, 0, 50] },
    ],
    bodies,
  );
  return { sight: new Sight(cameras, bodies), cameras };
}

const eye: Camera = {
  ...bay,
  name: 'AFT',
  kind: 'window',
  drive: null,
  field_of_view: 120 * degree,
  pane: { distance: 1, width: 0.4, height: 0.4 },
};

test('a camera sees a body that is in its picture and not hidden by another body', () => {
  const { sight } = place(body('payload', [10, 0, 0]));
  expect(sight.visible(bay, 'payload')).toBeGreaterThan(0);
  expect(place(body('payload', [10, -20, 0])).sight.visible(bay, 'payload')).toBe(0);
  expect(place(body('payload', [-10, 0, 0])).sight.visible(bay, 'payload')).toBe(0);
  expect(
    place(body('payload', [10, 0, 0]), body('wall', [5, 0, 0], [0.2, 8, 8])).sight.visible(bay, 'payload'),
  ).toBe(0);
  expect(
    place(body('payload', [10, 0, 0]), body('post', [5, 0, 0], [0.2, 0.2, 8])).sight.visible(bay, 'payload'),
  ).toBeGreaterThan(0);
  expect(sight.visible(bay, 'nothing')).toBe(0);
});

test('a camera that was turned sees the body in its new direction', () => {
  const { sight, cameras } = place(body('payload', [0, -10, 0]));
  expect(sight.visible(bay, 'payload')).toBe(0);
  cameras.put([[90 * degree, 0, 60 * degree]]);
  expect(sight.visible(bay, 'payload')).toBeGreaterThan(0);
  near(sight.direction(bay), [0, -1, 0]);
  cameras.put([[90 * degree, 0, 9 * degree]]);
  expect(cameras.project('B', 1, [0, -10, 0]).visible).toBe(true);
  expect(cameras.project('B', 1, [1, -10, 0]).visible).toBe(false);
});

test('a body that fills the picture is visible and hides others', () => {
  const wall = body('payload', [5, 40, 0], [0.2, 100, 100]);
  const { sight } = place(wall, body('post', [9, 0, 0]));
  expect(sight.visible(bay, 'payload')).toBe(0);
  expect([...sight.ahead(bay).keys()]).toEqual(['payload']);
  expect([...place().sight.ahead(bay).keys()]).toEqual([]);
});

test('a clearance line is visible if any part of it is unobstructed', () => {
  const [a, b]: [Vec3, Vec3] = [
    [10, -2, 0],
    [10, 2, 0],
  ];
  expect(place().sight.line(bay, a, b)).toBe(true);
  expect(place(body('post', [5, 0, 0], [0.2, 0.5, 8])).sight.line(bay, a, b)).toBe(true);
  expect(place(body('wall', [5, 0, 0], [0.2, 8, 8])).sight.line(bay, a, b)).toBe(false);
  expect(place().sight.ends(bay, a, b)).toEqual([true, true]);
  expect(place(body('post', [5, -1.5, 0], [0.2, 2, 8])).sight.ends(bay, a, b)).toEqual([false, true]);
  expect(place(body('wall', [5, 0, 0], [0.2, 8, 8])).sight.ends(bay, a, b)).toEqual([false, false]);
});

test('a window sees through its pane; bodies between the eye and the pane hide nothing', () => {
  const ahead = place(body('payload', [10, 0, 0]), body('wall', [0.5, 0, 0], [0.2, 8, 8]));
  expect(ahead.sight.visible(eye, 'payload')).toBeGreaterThan(0);
  // A pane edge 0.2 m from the axis, 1 m away, limits the view to 2 m from the axis at 10 m.
  expect(place(body('payload', [10, 4, 0])).sight.visible(eye, 'payload')).toBe(0);
  expect(
    place(body('wall', [1.5, 0, 0], [0.2, 8, 8]), body('payload', [10, 0, 0])).sight.visible(eye, 'payload'),
  ).toBe(0);
});

test('a body that another body hides in part is seen in part', () => {
  const whole = place(body('payload', [10, 0, 0])).sight.visible(bay, 'payload');
  const half = place(body('payload', [10, 0, 0]), body('wall', [9, 0, 4], [0.2, 8, 8])).sight;
  expect(whole).toBe(1);
  expect(half.visible(bay, 'payload')).toBeGreaterThan(0);
  expect(half.visible(bay, 'payload')).toBeLessThan(1);
});

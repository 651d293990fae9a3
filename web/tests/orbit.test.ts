import { Matrix4 } from 'three';
import { expect, test } from 'vitest';
import type { Camera } from '../src/link/protocol';
import { Orbit } from '../src/scene/orbit';
import { bay, near } from './camera-values';

test('the engineering view turns about its centre and stays level', () => {
  const camera: Camera = {
    ...bay,
    kind: 'engineering',
    drive: null,
    position: [-20, 20, 12],
    boresight: [20, -20, -12],
  };
  const orbit = new Orbit(camera);
  near(orbit.view.position, camera.position);
  const distance = Math.hypot(...orbit.view.position);
  orbit.turn(1, 0.2);
  expect(Math.hypot(...orbit.view.position)).toBeCloseTo(distance);
  orbit.approach(2);
  expect(Math.hypot(...orbit.view.position)).toBeCloseTo(distance / 2);
  orbit.turn(0, 10);
  expect(orbit.view.boresight[2]).toBeGreaterThan(-1);
  expect(orbit.view.up).toEqual([0, 0, 1]);
});

test('the engineering view turns about a followed point and can be shifted', () => {
  const orbit = new Orbit({
    ...bay,
    kind: 'engineering',
    drive: null,
    position: [0, -20, 0],
    boresight: [0, 20, 0],
  });
  const toBody = new Matrix4().makeTranslation(-1, 0, 0);
  orbit.turnTo([3, 0, 5], toBody);
  near(orbit.view.position, [2, -20, 5]);
  near(orbit.view.boresight, [0, 1, 0]);
  orbit.shift(0.1, 0);
  const [x = 0, y, z] = orbit.view.position;
  expect(x).toBeGreaterThan(2);
  near([2, y, z], [2, -20, 5]);
  orbit.follow([4, 0, 5], toBody);
  near(orbit.view.position, [x + 1, -20, 5]);
  orbit.turnTo(null, toBody);
  near(orbit.view.position, [0, -20, 0]);
});

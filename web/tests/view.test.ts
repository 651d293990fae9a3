import { expect, test } from 'vitest';
import type { Camera, Vec3 } from '../src/link/protocol';
import { settingOf, viewOf } from '../src/scene/view';
import { near } from './camera-values';
import views from './views.json';

interface Witness {
  readonly camera: Camera;
  readonly setting: Vec3;
  readonly position: Vec3;
  readonly boresight: Vec3;
  readonly up: Vec3;
}

const witnesses = views as unknown as readonly Witness[];

test('a drive setting gives the same view as in the simulation', () => {
  expect(witnesses.length).toBeGreaterThan(10);
  for (const { camera, setting, position, boresight, up } of witnesses) {
    const view = viewOf(camera, setting);
    near(view.position, position);
    near(view.boresight, boresight);
    near(view.up, up);
    expect(view.angle).toBe(setting[2]);
  }
});

test('the initial drive setting gives the initial view', () => {
  for (const { camera } of witnesses) {
    const view = viewOf(camera, settingOf(camera));
    near(view.position, camera.position);
    const size = Math.hypot(...camera.boresight);
    near(
      view.boresight,
      camera.boresight.map((value) => value / size),
    );
  }
});

import { expect, test } from 'vitest';
import { CameraHand, together, turningOf } from '../src/input/camera-hand';
import { DEFAULTS } from '../src/input/defaults';
import { bay, still } from './camera-values';

test('held keys push the camera switches; opposite keys cancel', () => {
  expect(turningOf(new Set(), DEFAULTS.keyboard)).toEqual(still);
  expect(turningOf(new Set(['ArrowRight', 'ArrowUp', 'PageDown', 'KeyW']), DEFAULTS.keyboard)).toEqual({
    pan: 1,
    tilt: 1,
    zoom: -1,
  });
  expect(turningOf(new Set(['ArrowLeft', 'ArrowRight']), DEFAULTS.keyboard)).toEqual(still);
});

test('a camera command is repeated while its key is held, and ends at its release', () => {
  Object.assign(globalThis, { window: globalThis, document: { hidden: false } });
  const sent: Record<string, unknown>[] = [];
  const messages: string[] = [];
  let turning = { ...still };
  let camera = bay;
  const hand = new CameraHand(() => turning, {
    hand: () => ({ camera, slow: true }),
    barred: () => '',
    say: (text) => messages.push(text),
    send: (command) => sent.push({ ...command }),
    orbit: () => {},
  });
  hand.dispose();
  let now = performance.now();
  const tick = (ms: number) => {
    now += ms;
    hand.tick(now);
  };
  tick(15);
  expect(sent).toEqual([]);
  turning = { ...still, pan: 1 };
  tick(15);
  tick(15);
  expect(sent).toEqual([{ type: 'drive_camera', camera: 'B', ...still, pan: 1, slow: true }]);
  tick(100);
  expect(sent).toHaveLength(2);
  turning = still;
  tick(15);
  tick(500);
  expect(sent.slice(2)).toEqual([{ type: 'drive_camera', camera: 'B', ...still, slow: true }]);
  camera = { ...bay, name: 'X', drive: null };
  turning = { ...still, tilt: 1 };
  tick(15);
  tick(15);
  expect(sent).toHaveLength(3);
  expect(messages).toEqual(['X is fixed.']);
});

test('keys and a drag add up to at most full deflection', () => {
  expect(together({ pan: 1, tilt: -0.5, zoom: 0 }, { pan: 0.7, tilt: 0.5, zoom: -1 })).toEqual({
    pan: 1,
    tilt: 0,
    zoom: -1,
  });
});

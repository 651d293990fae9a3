import { expect, test } from 'vitest';
import { CameraDrag } from '../src/input/camera-drag';
import { still } from './camera-values';

test('a drag pushes the camera switches in proportion to its length', () => {
  const drag = new CameraDrag();
  expect(drag.turning(0)).toEqual(still);
  drag.press(1, { x: 200, y: 150 }, 300);
  drag.move(1, { x: 202, y: 149 });
  expect(drag.turning(0)).toEqual(still);
  drag.move(1, { x: 230, y: 90 });
  const { pan, tilt, zoom } = drag.turning(0);
  expect(tilt / pan).toBeCloseTo(2);
  expect(zoom).toBe(0);
  expect(drag.line).toEqual({ from: { x: 200, y: 150 }, to: { x: 230, y: 90 } });
  drag.move(1, { x: -900, y: 900 });
  expect(drag.turning(0)).toEqual({ pan: -1, tilt: -1, zoom: 0 });
  drag.lift(1);
  expect(drag.turning(0)).toEqual(still);
  expect(drag.line).toBeNull();
});

test('a wheel notch zooms for a short time; the opposite notch reverses it', () => {
  const drag = new CameraDrag();
  drag.turnWheel(1, 1000);
  expect(drag.turning(1050).zoom).toBe(1);
  drag.turnWheel(-1, 1060);
  expect(drag.turning(1070).zoom).toBe(-1);
  expect(drag.turning(1500)).toEqual(still);
  for (let i = 0; i < 50; i += 1) drag.turnWheel(1, 2000);
  expect(drag.turning(2600)).toEqual(still);
});

test('two fingers zoom in when they move apart, and zoom out when they move together', () => {
  const drag = new CameraDrag();
  drag.press(1, { x: 100, y: 100 }, 300);
  drag.press(2, { x: 200, y: 100 }, 300);
  expect(drag.turning(0)).toEqual(still);
  drag.move(2, { x: 400, y: 100 });
  expect(drag.turning(0)).toEqual({ pan: 0, tilt: 0, zoom: 1 });
  drag.move(2, { x: 170, y: 100 });
  expect(drag.turning(0).zoom).toBeCloseTo(Math.log(0.7) / Math.log(2));
  drag.lift(1);
  drag.lift(2);
  expect(drag.turning(0)).toEqual(still);
});

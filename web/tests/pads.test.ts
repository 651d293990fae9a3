import { expect, test } from 'vitest';
import { isZero } from '../src/input/deflection';
import { Pads } from '../src/input/pads';
import { NO_AXES, plugged } from './gamepads';

test('the pad that moves first is the THC until the pads are swapped', () => {
  const world = plugged({ id: 'Left' }, { id: 'Right' });
  const pads = new Pads(() => {});
  pads.poll(0);
  expect(pads.devices.map(({ kind }) => kind)).toEqual(['pad']);
  world.axes(1, 0, -1, 0, 0);
  expect(isZero(pads.poll(20))).toBe(true);
  expect(pads.devices.map(({ kind, name }) => `${kind} ${name}`)).toEqual(['thc pad Left', 'rhc pad Right']);
  expect(pads.asks).toBe(true);
  world.axes(1, ...NO_AXES);
  pads.poll(40);
  world.axes(0, 0, -1, 0, 0);
  world.axes(1, 0.5, -1, 0, 0);
  const [x, y, , roll, pitch] = pads.poll(60);
  expect([x, y, pitch]).toEqual([1, 0, 1]);
  expect(roll).toBeGreaterThan(0);
  pads.swap();
  expect(pads.asks).toBe(false);
  expect(isZero(pads.poll(80))).toBe(true);
  expect(pads.devices.map(({ name }) => name)).toEqual(['Right', 'Left']);
});

test('a joystick that was never moved is not used', () => {
  const world = plugged(
    { id: 'Stick', standard: false, axes: [0, 0, 0, 1], buttons: { 5: 1 } },
    { id: 'Pad' },
  );
  const pads = new Pads(() => {});
  pads.poll(0);
  expect(pads.devices.map(({ name }) => name)).toEqual(['Pad']);
  for (let now = 20; now < 100; now += 20) pads.poll(now);
  expect(pads.devices.map(({ name }) => name)).toEqual(['Pad']);
  world.axes(0, 0, -0.5, 0, 1);
  pads.poll(120);
  expect(pads.devices.map(({ kind }) => kind)).toEqual(['thc pad', 'rhc joystick']);
});

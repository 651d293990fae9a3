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

/** Moves a device forward, centres it, and returns the deflections when it is moved forward again. */
function afterMotion(world: ReturnType<typeof plugged>, pads: Pads, which: number): readonly number[] {
  const forward = [0, -1, 0, 0];
  pads.poll(1000);
  world.axes(which, ...forward);
  pads.poll(1020);
  world.axes(which, ...NO_AXES);
  for (let now = 1040; now <= 2600; now += 20) pads.poll(now);
  world.axes(which, ...forward);
  const value = pads.poll(2620);
  world.axes(which, ...NO_AXES);
  pads.poll(2640);
  return value;
}

const flown = (pads: Pads) => pads.devices.map(({ kind, name, state }) => `${kind} ${name} ${state}`);

test('a device that is moved after the only pad was lost is the THC', () => {
  const world = plugged({ id: 'Pad' }, { id: 'Stick', standard: false });
  const pads = new Pads(() => {});
  pads.poll(0);
  pads.poll(20);
  world.unplug(0);
  pads.poll(40);
  expect(flown(pads)).toEqual(['pad Pad lost']);
  expect(afterMotion(world, pads, 1)[0]).toBe(1);
  expect(flown(pads)).toEqual(['thc joystick Stick flying']);
  expect(pads.asks).toBe(false);
  world.plug(0);
  expect(afterMotion(world, pads, 0)[4]).toBe(1);
  expect(flown(pads)).toEqual(['thc joystick Stick flying', 'rhc pad Pad flying']);
});

test('two devices are lost: the next moved device is the THC, and the other one has its place again', () => {
  const world = plugged({ id: 'Left' }, { id: 'Right' }, { id: 'Third', standard: false });
  const pads = new Pads(() => {});
  pads.poll(0);
  afterMotion(world, pads, 1);
  expect(flown(pads)).toEqual(['thc pad Left flying', 'rhc pad Right flying']);
  world.unplug(0);
  world.unplug(1);
  pads.poll(1100);
  expect(flown(pads)).toEqual(['thc pad Left lost', 'rhc pad Right lost']);
  expect(afterMotion(world, pads, 2)[0]).toBe(1);
  expect(flown(pads)).toEqual(['thc joystick Third flying', 'rhc pad Right lost']);
  world.plug(1);
  expect(afterMotion(world, pads, 1)[4]).toBe(1);
  expect(flown(pads)).toEqual(['thc joystick Third flying', 'rhc pad Right flying']);
  world.plug(0);
  expect(afterMotion(world, pads, 0)[0]).toBe(0);
});

test('of two equal devices that are lost, the first to return is the THC', () => {
  const world = plugged({ id: 'Twin' }, { id: 'Twin' });
  const pads = new Pads(() => {});
  pads.poll(0);
  afterMotion(world, pads, 1);
  world.unplug(0);
  world.unplug(1);
  pads.poll(1100);
  world.plug(1);
  expect(afterMotion(world, pads, 1)[0]).toBe(1);
  world.plug(0);
  expect(afterMotion(world, pads, 0)[4]).toBe(1);
  expect(pads.asks).toBe(true);
});

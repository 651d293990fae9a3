import { beforeEach, expect, test, vi } from 'vitest';
import { Controllers } from '../src/input/controllers';
import { isZero } from '../src/input/deflection';
import { NO_AXES, plugged } from './gamepads';

beforeEach(() => void vi.stubGlobal('window', { addEventListener() {} }));

test('the loss of a device centres all devices; acknowledging removes the lost device', () => {
  const world = plugged({ id: 'Left' }, { id: 'Right' });
  const controllers = new Controllers(() => {}, { moved() {}, taken: () => false });
  controllers.poll(0, 0);
  world.axes(1, 0, -1, 0, 0);
  controllers.poll(20, 0);
  world.axes(1, ...NO_AXES);
  controllers.poll(40, 0);
  world.axes(0, 0, -1, 0, 0);
  controllers.keyboard.held.add('KeyD');
  expect(controllers.poll(60, 1).slice(0, 2)).toEqual([1, 1]);
  world.unplug(1);
  expect(isZero(controllers.poll(80, 0.01))).toBe(true);
  expect(controllers.keyboard.held.size).toBe(0);
  expect(controllers.shown.gone).toEqual({ thc: null, rhc: 'Right' });
  expect(isZero(controllers.poll(100, 0.01))).toBe(true);
  controllers.acknowledge();
  expect(controllers.devices.map(({ kind, name }) => `${kind} ${name}`)).toEqual(['pad Left']);
  world.plug(1);
  controllers.poll(120, 0.01);
  expect(controllers.devices.map(({ name }) => name)).toEqual(['Left']);
  expect(controllers.lost).toEqual([]);
});

test('all devices are centred when one is lost while another takes the place of a lost one', () => {
  const world = plugged({ id: 'Left' }, { id: 'Right' }, { id: 'Third' });
  const controllers = new Controllers(() => {}, { moved() {}, taken: () => false });
  const after = (now: number, which: number, y: number) => {
    world.axes(which, 0, y, 0, 0);
    return controllers.poll(now, 0.01);
  };
  after(0, 0, 0);
  after(20, 1, -1);
  after(40, 1, 0);
  world.unplug(1);
  after(60, 0, 0);
  after(80, 0, 0);
  world.unplug(0);
  controllers.keyboard.held.add('KeyD');
  expect(isZero(after(100, 2, -1))).toBe(true);
  expect(controllers.keyboard.held.size).toBe(0);
  expect(controllers.lost.map(({ name }) => name)).toEqual(['Left']);
});

test('the desk names a lost device, and asks to centre a device that is plugged in again off centre', () => {
  const world = plugged({ id: 'Left' });
  const controllers = new Controllers(() => {}, { moved() {}, taken: () => false });
  const words = (now: number) => {
    controllers.poll(now, 0.01);
    return controllers.shown.words;
  };
  expect(words(0)).toBe('Left and keyboard in use');
  world.axes(0, 0, -1, 0, 0);
  world.unplug(0);
  expect(words(20)).toBe('Left lost; use the keys');
  world.plug(0);
  expect(words(40)).toBe('Centre: Left');
  world.axes(0, ...NO_AXES);
  expect(words(60)).toBe('Left and keyboard in use');
});

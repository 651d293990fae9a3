import { expect, test } from 'vitest';
import type { Action } from '../src/input/action';
import { isZero } from '../src/input/deflection';
import { Device } from '../src/input/device';
import { nameOfSource } from '../src/input/layout';
import { KINDS } from '../src/input/mapping';
import { deflection } from '../src/input/reading';
import { mappingOf, restore } from '../src/input/store';
import { NO_AXES, reading } from './gamepads';

const PAD = mappingOf('pad');
/** Returns the deflections of the seven stick axes for a reading of one pad. */
function flown(axes: readonly number[], pressed: Record<number, number> = {}): readonly number[] {
  return deflection(reading(axes, pressed), PAD).slice(0, 7);
}

test('a pad at rest has zero deflections without a negative sign', () => {
  expect(flown(NO_AXES).every((value) => Object.is(value, 0))).toBe(true);
  expect(isZero(flown([0.05, -0.05, 0.07, 0]))).toBe(true);
});

test('the left stick commands X and Y, the triggers command Z', () => {
  expect(flown([0, -1, 0, 0])).toEqual([1, 0, 0, 0, 0, 0, 0]);
  expect(flown([1, 0, 0, 0])).toEqual([0, 1, 0, 0, 0, 0, 0]);
  expect(flown(NO_AXES, { 6: 1 })).toEqual([0, 0, -1, 0, 0, 0, 0]);
  expect(flown(NO_AXES, { 7: 1 })).toEqual([0, 0, 1, 0, 0, 0, 0]);
});

test('the right stick commands pitch and yaw, the bumpers command roll', () => {
  expect(flown([0, 0, 0, -1])).toEqual([0, 0, 0, 0, 1, 0, 0]);
  expect(flown([0, 0, 1, 0])).toEqual([0, 0, 0, 0, 0, 1, 0]);
  expect(flown(NO_AXES, { 4: 1 })).toEqual([0, 0, 0, -1, 0, 0, 0]);
});

test('the cross with Menu drives the telescope; without Menu it tilts the camera', () => {
  expect(flown(NO_AXES, { 9: 1, 12: 1 })).toEqual([0, 0, 0, 0, 0, 0, 1]);
  expect(flown(NO_AXES, { 9: 1, 13: 1 })).toEqual([0, 0, 0, 0, 0, 0, -1]);
  expect(deflection(reading(NO_AXES, { 12: 1 }), PAD)).toEqual([0, 0, 0, 0, 0, 0, 0, 0, 1, 0]);
  expect(deflection(reading(NO_AXES, { 9: 1, 12: 1 }), PAD).slice(7)).toEqual([0, 0, 0]);
});

/** A pad whose buttons a test presses. `press` returns names of actions; + and - mark start and end of a hold. */
function pressed() {
  const acted: string[] = [];
  const device = new Device('pad', (action: Action) =>
    acted.push(action.name === 'grip' ? `${action.grip}${action.down ? '+' : '-'}` : action.name),
  );
  return {
    device,
    press(...indices: number[]) {
      device.read(reading(NO_AXES, Object.fromEntries(indices.map((index) => [index, 1]))), 0);
      return acted.splice(0);
    },
    unplug() {
      device.read(null, 0);
      return acted.splice(0);
    },
  };
}

test('North captures; Menu with North releases', () => {
  const { press } = pressed();
  expect(press(3)).toEqual(['close+']);
  expect(press()).toEqual(['close-']);
  expect(press(9)).toEqual([]);
  expect(press(9, 3)).toEqual(['open+']);
  expect(press(3)).toEqual([]);
  expect(press()).toEqual(['open-']);
});

test('Menu alone steps the camera when it is released', () => {
  const { press } = pressed();
  expect([press(9), press()]).toEqual([[], ['cameraStep +']]);
  expect([press(9), press(9, 8), press(9), press()]).toEqual([[], ['fly orbiter'], [], []]);
  expect([press(9), press(9, 12), press()]).toEqual([[], [], []]);
});

test('View with a button works the panel; View alone selects the other monitor', () => {
  const { press } = pressed();
  expect([press(8), press(8, 15), press(8), press(8, 0), press()]).toEqual([
    [],
    ['mode +'],
    [],
    ['enter'],
    [],
  ]);
  expect([press(8), press(8, 3), press()]).toEqual([[], ['proceed'], []]);
  expect([press(8), press(8, 2), press(2), press()]).toEqual([[], ['brakes+'], [], ['brakes-']]);
  expect([press(8), press()]).toEqual([[], ['otherMonitor']]);
});

test('a lost or disarmed pad ends its held functions', () => {
  const first = pressed();
  first.press(3);
  expect(first.unplug()).toEqual(['close-']);
  const second = pressed();
  second.press(3);
  second.device.disarm();
  expect(second.press(3)).toEqual(['close-']);
  expect(second.press()).toEqual([]);
});

test('East stops, also with Menu', () => {
  const { press } = pressed();
  expect(press(1)).toEqual(['stop']);
  press();
  press(9);
  expect(press(9, 1)).toEqual(['stop']);
});

test('a lost device is zeroed at once, and is used again after it was centred', () => {
  const device = new Device('pad', () => {});
  expect(isZero(device.read(reading([0, -1, 0, 0]), 0))).toBe(true);
  expect(device.state).toBe('waiting');
  for (let now = 10; now <= 1600; now += 10) device.read(reading(NO_AXES), now);
  expect(device.read(reading([0, -1, 0, 0]), 1620)[0]).toBe(1);
  expect(isZero(device.read(null, 1630))).toBe(true);
  expect(device.state).toBe('lost');
  expect(isZero(device.read(reading([0, -1, 0, 0]), 1640))).toBe(true);
  device.read(reading([0, 0.02, 0, 0]), 1650);
  expect(device.read(reading([0, -1, 0, 0]), 1660)[0]).toBe(1);
});

test('a device with a sensor off centre is reported, and is used after it was zeroed', () => {
  const device = new Device('pad', () => {});
  const atRest = reading([0.2, 0, 0, 0]);
  for (let now = 0; now <= 10_000; now += 100) device.read(atRest, now);
  expect(device.state).toBe('waiting');
  expect(device.resting).toBe(true);
  expect(mappingOf('pad').centres).toEqual([]);
  expect(device.setZero()).toEqual([]);
  expect(isZero(device.read(atRest, 10_100))).toBe(true);
  expect(device.state).toBe('flying');
  expect(device.read(reading([1, 0, 0, 0]), 10_200)[1]).toBe(1);
  expect(device.read(reading([-1, 0, 0, 0]), 10_300)[1]).toBe(-1);
  restore('pad');
});

test('zero is set for the other axes of a device with a trigger that rests at −1', () => {
  const device = new Device('thc joystick', () => {});
  const atRest = reading([0.2, 0, -1]);
  device.read(atRest, 0);
  expect(device.setZero()).toEqual(['a2']);
  expect(isZero(device.read(atRest, 20))).toBe(true);
  expect(device.read(reading([1, -1, -1]), 40).slice(0, 3)).toEqual([1, 1, 0]);
  expect(device.read(reading([0.2, 0, 1]), 60)[2]).toBe(0);
  restore('thc joystick');
});

test('a stick that the operator holds off centre does not count as a sensor off centre', () => {
  const device = new Device('pad', () => {});
  for (let now = 0; now <= 10_000; now += 100) device.read(reading([0.2 + 0.05 * (now % 200), 0, 0, 0]), now);
  expect(device.resting).toBe(false);
});

test('an axis or button that is not a number counts as 0 and is named, on every kind of device', () => {
  for (const kind of KINDS) {
    if (kind === 'keyboard') continue;
    for (const value of [Number.NaN, Infinity, -Infinity, undefined as unknown as number]) {
      const device = new Device(kind, () => {});
      const parts = Array.from({ length: 17 }, () => ({ pressed: false, value }));
      const noNumbers = { axes: Array<number>(6).fill(value), buttons: parts };
      for (let now = 0; now < 4000; now += 100)
        expect(device.read(noNumbers, now).every((each) => Object.is(each, 0))).toBe(true);
      for (const source of Object.keys(mappingOf(kind).bindings).filter((each) => !each.includes('+')))
        expect(device.faults.join()).toContain(nameOfSource(kind, source));
      expect(device.state).toBe('flying');
      expect(device.reading?.axes).toEqual([0, 0, 0, 0, 0, 0]);
      device.read(reading(Array<number>(6).fill(0)), 4000);
      expect(isZero(device.read(reading([1, 0, 0, 0, 0, 0]), 4010))).toBe(false);
    }
  }
});

test('an axis is named only while it sends no number, and only if it has a function', () => {
  const device = new Device('thc joystick', () => {});
  device.read(reading([0, Number.NaN, 0, Number.NaN]), 0);
  expect(device.faults).toEqual([`${nameOfSource('thc joystick', 'a1')} sends no number and counts as 0`]);
  device.read(reading(NO_AXES), 20);
  expect(device.faults).toEqual([]);
});

import { describe, expect, it, test, vi } from 'vitest';
import { Controllers } from '../src/input/controllers';
import { isZero, PAN, sum, X, ZERO } from '../src/input/deflection';
import { Device, deflection, type Reading } from '../src/input/device';
import { ramp } from '../src/input/keyboard';
import type { Action } from '../src/input/keymap';
import { learnLetter, nameOf } from '../src/input/layout';
import { Pads } from '../src/input/pads';
import { zeroed } from '../src/input/rebind';
import { routed, Sticks } from '../src/input/sticks';
import { mappingOf, restore, save } from '../src/input/store';

const NO_AXES = [0, 0, 0, 0];

function reading(axes: readonly number[], pressed: Record<number, number> = {}): Reading {
  const buttons = Array.from({ length: 17 }, (_, i) => ({
    pressed: (pressed[i] ?? 0) > 0.5,
    touched: false,
    value: pressed[i] ?? 0,
  }));
  return { axes, buttons };
}

const PAD = mappingOf('pad');
/** The seven stick axes that a reading of one pad deflects. */
function flown(axes: readonly number[], pressed: Record<number, number> = {}): readonly number[] {
  return deflection(reading(axes, pressed), PAD).slice(0, 7);
}

/** Gamepads that a test plugs in and moves; the station's own code asks for them. */
function plugged(
  ...pads: { id: string; axes?: number[]; standard?: boolean; buttons?: Record<number, number> }[]
) {
  const there = pads.map((pad, index) => ({ ...pad, index }));
  const listed: (number | null)[] = there.map(({ index }) => index);
  vi.stubGlobal('navigator', {
    getGamepads: () =>
      listed.map((which) => {
        const pad = which === null ? undefined : there[which];
        if (!pad) return null;
        return {
          ...reading(pad.axes ?? NO_AXES, pad.buttons),
          connected: true,
          mapping: (pad.standard ?? true) ? 'standard' : '',
          id: pad.id,
          index: pad.index,
        };
      }),
  });
  return {
    axes(which: number, ...axes: number[]) {
      const pad = there[which];
      if (pad) pad.axes = axes;
    },
    unplug(which: number) {
      listed[which] = null;
    },
    plug(which: number) {
      listed[which] = which;
    },
  };
}

test('a key reaches full deflection in 0.35 s and zero in 0.15 s', () => {
  expect(ramp(0, 1, 0.175)).toBeCloseTo(0.5);
  expect(ramp(0, 1, 0.36)).toBe(1);
  expect(ramp(1, 0, 0.075)).toBeCloseTo(0.5);
  expect(ramp(-1, 0, 0.16)).toBe(0);
});

test('an axis changes sides through zero', () => {
  expect(ramp(0.1, -1, 0.1)).toBe(0);
  expect(ramp(0, -1, 0.035)).toBeCloseTo(-0.1);
});

test('a pad at rest is at zero, signs included', () => {
  expect(flown(NO_AXES).every((value) => Object.is(value, 0))).toBe(true);
  expect(isZero(flown([0.05, -0.05, 0.07, 0]))).toBe(true);
});

test('the left stick translates, away is +X; the triggers lift and lower', () => {
  expect(flown([0, -1, 0, 0])).toEqual([1, 0, 0, 0, 0, 0, 0]);
  expect(flown([1, 0, 0, 0])).toEqual([0, 1, 0, 0, 0, 0, 0]);
  expect(flown(NO_AXES, { 6: 1 })).toEqual([0, 0, -1, 0, 0, 0, 0]);
  expect(flown(NO_AXES, { 7: 1 })).toEqual([0, 0, 1, 0, 0, 0, 0]);
});

test('the right stick pitches and yaws; the bumpers roll', () => {
  expect(flown([0, 0, 0, -1])).toEqual([0, 0, 0, 0, 1, 0, 0]);
  expect(flown([0, 0, 1, 0])).toEqual([0, 0, 0, 0, 0, 1, 0]);
  expect(flown(NO_AXES, { 4: 1 })).toEqual([0, 0, 0, -1, 0, 0, 0]);
});

test('Menu and the cross put the telescope; the cross alone tilts the camera in hand', () => {
  expect(flown(NO_AXES, { 9: 1, 12: 1 })).toEqual([0, 0, 0, 0, 0, 0, 1]);
  expect(flown(NO_AXES, { 9: 1, 13: 1 })).toEqual([0, 0, 0, 0, 0, 0, -1]);
  expect(deflection(reading(NO_AXES, { 12: 1 }), PAD)).toEqual([0, 0, 0, 0, 0, 0, 0, 0, 1, 0]);
  expect(deflection(reading(NO_AXES, { 9: 1, 12: 1 }), PAD).slice(7)).toEqual([0, 0, 0]);
});

test('all devices together stay within full deflection', () => {
  const both = sum([0.8, -0.5, 0, 0, 0, 0, 0], [0.8, -0.2, 0, 0, 0, 0, 0]);
  expect(both.slice(0, 2)).toEqual([1, -0.7]);
  expect(isZero(sum(ZERO, ZERO))).toBe(true);
});

/** A pad whose buttons a test presses, and what it did: an action's name, a grip with + and -. */
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

test('north is held to capture, with Menu to release', () => {
  const { press } = pressed();
  expect(press(3)).toEqual(['close+']);
  expect(press()).toEqual(['close-']);
  expect(press(9)).toEqual([]);
  expect(press(9, 3)).toEqual(['open+']);
  expect(press(3)).toEqual([]);
  expect(press()).toEqual(['open-']);
});

test('Menu alone steps the camera as it comes up; with another button it does not', () => {
  const { press } = pressed();
  expect([press(9), press()]).toEqual([[], ['cameraStep']]);
  expect([press(9), press(9, 8), press(9), press()]).toEqual([[], ['fly orbiter'], [], []]);
  expect([press(9), press(9, 12), press()]).toEqual([[], [], []]);
});

test('what is held is let go with the pad, and when the sticks are taken away', () => {
  const first = pressed();
  first.press(3);
  expect(first.unplug()).toEqual(['close-']);
  const second = pressed();
  second.press(3);
  second.device.disarm();
  expect(second.press(3)).toEqual(['close-']);
  expect(second.press()).toEqual([]);
});

test('east stops, with Menu too', () => {
  const { press } = pressed();
  expect(press(1)).toEqual(['stop']);
  press();
  press(9);
  expect(press(9, 1)).toEqual(['stop']);
});

test('a device that is gone is at zero in the same look, and flies only once it was seen at zero', () => {
  const device = new Device('pad', () => {});
  expect(isZero(device.read(reading([0, -1, 0, 0]), 0))).toBe(true);
  expect(device.state).toBe('waiting');
  device.read(reading(NO_AXES), 10);
  expect(device.read(reading([0, -1, 0, 0]), 20)[0]).toBe(1);
  expect(isZero(device.read(null, 30))).toBe(true);
  expect(device.state).toBe('lost');
  expect(isZero(device.read(reading([0, -1, 0, 0]), 40))).toBe(true);
  device.read(reading([0, 0.02, 0, 0]), 50);
  expect(device.read(reading([0, -1, 0, 0]), 60)[0]).toBe(1);
});

test('a sensor that rests off centre is told of, and flown only after the operator has zeroed it', () => {
  const device = new Device('pad', () => {});
  const rests = reading([0.2, 0, 0, 0]);
  for (let now = 0; now <= 10_000; now += 100) device.read(rests, now);
  expect(device.state).toBe('waiting');
  expect(device.resting).toBe(true);
  expect(mappingOf('pad').centres).toEqual([]);
  save('pad', zeroed('pad', mappingOf('pad'), rests.axes));
  expect(isZero(device.read(rests, 10_100))).toBe(true);
  expect(device.state).toBe('flying');
  expect(device.read(reading([1, 0, 0, 0]), 10_200)[1]).toBe(1);
  expect(device.read(reading([-1, 0, 0, 0]), 10_300)[1]).toBe(-1);
  restore('pad');
});

test('a hand that holds a stick off centre is no sensor that rests there', () => {
  const device = new Device('pad', () => {});
  for (let now = 0; now <= 10_000; now += 100) device.read(reading([0.2 + 0.05 * (now % 200), 0, 0, 0]), now);
  expect(device.resting).toBe(false);
});

test('of two pads the one moved first is the THC; swapped, the other one', () => {
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

test('a joystick that nobody moved flies nothing, though it rests anywhere', () => {
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

test('a lost device takes all others to zero too, and acknowledged it is forgotten', () => {
  const world = plugged({ id: 'Left' }, { id: 'Right' });
  vi.stubGlobal('window', { addEventListener() {} });
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

test('the THC moves the arm or the orbiter, never both; the RHC and the telescope stay', () => {
  const value = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7];
  const rest = { rotation: [0.4, 0.5, 0.6], drive: 0, telescope: 0.7 };
  expect(routed(value, false, false)).toEqual({ ...rest, translation: [0.1, 0.2, 0.3], orbiter: [0, 0, 0] });
  expect(routed(value, false, true)).toEqual({ ...rest, translation: [0, 0, 0], orbiter: [0.1, 0.2, 0.3] });
});

test('driving one joint, X drives it unless it flies the orbiter', () => {
  const value = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0];
  expect(routed(value, true, false)).toMatchObject({
    translation: [0, 0, 0],
    rotation: [0, 0, 0],
    drive: 0.1,
  });
  expect(routed(value, true, true)).toMatchObject({ drive: 0, orbiter: [0.1, 0.2, 0.3] });
});

test('a key pressed alone tells what stands on it, and with another one held it does not', () => {
  const alone = { shiftKey: false, ctrlKey: false, altKey: false, metaKey: false };
  expect(nameOf('KeyQ')).toBe('Q');
  learnLetter({ ...alone, code: 'KeyQ', key: '!', shiftKey: true });
  learnLetter({ ...alone, code: 'KeyQ', key: 'Dead' });
  expect(nameOf('KeyQ')).toBe('Q');
  learnLetter({ ...alone, code: 'KeyQ', key: 'a' });
  learnLetter({ ...alone, code: 'KeyW', key: 'w' });
  expect([nameOf('KeyQ'), nameOf('KeyW')]).toEqual(['A', 'W']);
  learnLetter({ ...alone, code: 'KeyQ', key: 'q' });
  expect(nameOf('KeyQ')).toBe('Q');
});

describe('stick to picture', () => {
  const still = Array.from({ length: 10 }, () => 0);
  /** Sticks whose devices stand as told; what was measured of them, by number of the message. */
  function stickOf(at: { value: readonly number[]; moved: boolean }) {
    const told: number[] = [];
    const latency = { sent: (_seq: number, from: number) => told.push(from) };
    const controllers = {
      poll: () => at.value,
      release() {},
      get moved() {
        return at.moved;
      },
    };
    const sticks = new Sticks(controllers as never, latency as never, () => 0);
    return { sticks, told };
  }
  const standing = (axis: number, value: number) => still.map((rest, i) => (i === axis ? value : rest));

  it('is counted from the input that moved a stick, not from a camera’s key before it', () => {
    const at = { value: standing(PAN, 1), moved: false };
    const { sticks, told } = stickOf(at);
    sticks.moved(1000); // a camera's key
    at.value = still;
    sticks.tick(2000);
    at.value = standing(X, 0.5);
    sticks.moved(6000);
    expect(told).toEqual([6000]);
  });

  it('is not counted from a device’s motion that flew nothing, as before it was seen at zero', () => {
    const at = { value: still, moved: true };
    const { sticks, told } = stickOf(at);
    sticks.tick(1000);
    sticks.tick(1015);
    [at.value, at.moved] = [standing(X, 0.5), true];
    sticks.tick(4000);
    at.moved = false;
    sticks.tick(4200); // said again, as it is held
    expect(told).toEqual([4000]);
  });
});

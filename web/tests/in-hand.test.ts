import { expect, test } from 'vitest';
import { InHand, KEYS } from '../src/input/active-device';
import { DEFAULTS } from '../src/input/defaults';
import { Device } from '../src/input/device';
import type { Kind } from '../src/input/mapping';
import { goParts } from '../src/task/to-go';
import { unitsOf } from '../src/words/units';
import { wayOutText } from '../src/words/way-out';
import { reading } from './gamepads';
import { toGo } from './worksite';

const SI = unitsOf('SI');
const WAY = { cause: 'elbow', text: '', position: '' };
const WAYS = [
  { ...WAY, stick: 'translation', axis: 0, sign: 1 },
  { ...WAY, stick: 'translation', axis: 2, sign: -1 },
  { ...WAY, stick: 'rotation', axis: 0, sign: -1 },
] as const;

/** Devices of these kinds whose axes and `keys` a test moves; `first`: the first axes, at which they were connected. */
function held(kinds: readonly Kind[], first: readonly number[] = [0, 0, 0, 0, 0, 0]) {
  const devices = kinds.map((kind) => new Device(kind, () => {}));
  const keys = new Set<string>();
  const inHand = new InHand({ devices, keyboard: { held: keys } } as never);
  const put = (which: number, axes: readonly number[] | null) => {
    devices[which]?.read(axes && reading(axes), 0);
    inHand.look();
  };
  devices.forEach((_, which) => {
    put(which, first);
  });
  return { devices, keys, inHand, move: (...axes: number[]) => put(0, axes), put };
}

test('the device that was moved last is named until a key is pressed', () => {
  const { inHand, keys, move, put } = held(['pad']);
  const words = () => {
    inHand.look();
    return WAYS.map((way) => wayOutText(way, '', inHand)).join(', ');
  };
  expect(words()).toBe('THC +X (W), THC −Z (Q), RHC −roll (U)');
  move(0, -0.6, 0, 0);
  expect(words()).toBe('THC +X (L↑), THC −Z (LT), RHC −roll (LB)');
  move(0, 0, 0, 0);
  expect(inHand.name('latch')).toBe('Menu + South');
  expect(goParts(toGo({ translation: [0.3, 0, 0] }), SI, inHand, [])[0]).toMatchObject({
    stick: '+X',
    handle: 'L↑',
  });
  keys.add('KeyW');
  expect(words()).toContain('THC +X (W)');
  keys.clear();
  move(0, -0.6, 0, 0);
  expect(words()).toContain('THC +X (L↑)');
  put(0, null);
  expect(words()).toContain('THC +X (W)');
});

test('each axis has a unique short name on every device', () => {
  for (const [kind, mapping] of Object.entries(DEFAULTS)) {
    if (kind === 'keyboard') continue;
    const [first = ''] = Object.keys(mapping.bindings);
    const axes = [0, 0, 0, 0, 0, 0];
    axes[Number(first.slice(1))] = 1;
    const { inHand, move } = held([kind as Kind]);
    move(...axes);
    expect(inHand.device?.kind, kind).toBe(kind);
    const uses = Object.values(mapping.bindings).filter((use) => /^[+-](X|Y|Z|roll|pitch|yaw)$/.test(use));
    const both = new Set(uses.flatMap((use) => [`+${use.slice(1)}`, `-${use.slice(1)}`]));
    const names = [...both].map((use) => inHand.short(use));
    expect(new Set(names).size, `${kind}: ${names}`).toBe(both.size);
    for (const name of names) expect(name).toMatch(/^.{1,4}$/u);
    for (const use of both) expect(inHand.short(use)).not.toBe(KEYS.short(use));
  }
});

test('a device that is lost is not named', () => {
  const { inHand, put } = held(['thc pad', 'rhc pad']);
  put(1, [0, 1, 0, 0]);
  expect([inHand.short('+pitch'), inHand.short('+X')]).toEqual(['L↑', 'L↑']);
  put(0, null);
  expect([inHand.short('+pitch'), inHand.short('+X')]).toEqual(['L↑', 'W']);
});

test('a device with an axis that rests off centre is named when its other axes move the arm', () => {
  const { devices, inHand, move, put } = held(['thc joystick', 'rhc joystick'], [0, 0, -1, 0]);
  const names = () => [inHand.short('+X'), inHand.short('+pitch')];
  expect(devices.map(({ state }) => state)).toEqual(['waiting', 'waiting']);
  expect(names()).toEqual(['W', 'I']);
  expect([inHand.holds('+Z'), inHand.holds('-Z')]).toEqual([false, false]);
  move(0, -1, -1, 0);
  expect(inHand.holds('+X')).toBe(true);
  expect(names()).toEqual(['1−', '1−']);
  move(0, 0, -1, 0);
  put(1, [0, 1, -1, 0]);
  expect(inHand.device).toBe(devices[1]);
});

import { expect, test } from 'vitest';
import { InHand, KEYS } from '../src/input/active-device';
import { DEFAULTS } from '../src/input/defaults';
import { goParts } from '../src/task/to-go';
import { unitsOf } from '../src/words/units';
import { wayOutText } from '../src/words/way-out';
import { toGo } from './worksite';

const SI = unitsOf('SI');
const WAY = { cause: 'elbow', text: '', position: '' };
const WAYS = [
  { ...WAY, stick: 'translation', axis: 0, sign: 1 },
  { ...WAY, stick: 'translation', axis: 2, sign: -1 },
  { ...WAY, stick: 'rotation', axis: 0, sign: -1 },
] as const;

test('the device that was moved last is named until a key is pressed', () => {
  const still = Array.from({ length: 17 }, () => ({ pressed: false, value: 0 }));
  const device = {
    kind: 'pad',
    state: 'flying',
    mapping: DEFAULTS.pad,
    reading: { axes: [0, 0, 0, 0], buttons: still },
  };
  const held = new Set<string>();
  const inHand = new InHand({ devices: [device], keyboard: { held } } as never);
  const words = () => {
    inHand.look();
    return WAYS.map((way) => wayOutText(way, '', inHand)).join(', ');
  };
  expect(words()).toBe('THC +X (W), THC −Z (Q), RHC −roll (U)');
  device.reading.axes = [0, -0.6, 0, 0];
  expect(words()).toBe('THC +X (L↑), THC −Z (LT), RHC −roll (LB)');
  device.reading.axes = [0, 0, 0, 0];
  expect(inHand.name('latch')).toBe('Menu + South');
  expect(goParts(toGo({ translation: [0.3, 0, 0] }), SI, inHand)[0]).toMatchObject({
    stick: '+X',
    handle: 'L↑',
  });
  held.add('KeyW');
  expect(words()).toContain('THC +X (W)');
  held.clear();
  device.reading.axes = [0, -0.6, 0, 0];
  expect(words()).toContain('THC +X (L↑)');
  device.state = 'lost';
  expect(words()).toContain('THC +X (W)');
});

test('each axis has a unique short name on every device', () => {
  for (const [kind, mapping] of Object.entries(DEFAULTS)) {
    if (kind === 'keyboard') continue;
    const [first = ''] = Object.keys(mapping.bindings);
    const axes = [0, 0, 0, 0, 0, 0];
    axes[Number(first.slice(1))] = 1;
    const inHand = new InHand({
      devices: [{ kind, mapping, state: 'flying', reading: { axes, buttons: [] } }],
      keyboard: { held: new Set() },
    } as never);
    inHand.look();
    expect(inHand.device?.kind, kind).toBe(kind);
    const uses = Object.values(mapping.bindings).filter((use) => /^[+-](X|Y|Z|roll|pitch|yaw)$/.test(use));
    const both = new Set(uses.flatMap((use) => [`+${use.slice(1)}`, `-${use.slice(1)}`]));
    const names = [...both].map((use) => inHand.short(use));
    expect(new Set(names).size, `${kind}: ${names}`).toBe(both.size);
    for (const name of names) expect(name).toMatch(/^.{1,4}$/u);
    for (const use of both) expect(inHand.short(use)).not.toBe(KEYS.short(use));
  }
});

test('a device that is lost or off centre is not named', () => {
  const pad = (kind: 'thc pad' | 'rhc pad') => ({
    kind,
    state: 'flying',
    mapping: DEFAULTS[kind],
    reading: { axes: [0, 0, 0, 0], buttons: [] },
  });
  const [thc, rhc] = [pad('thc pad'), pad('rhc pad')];
  const held = new Set<string>();
  const inHand = new InHand({ devices: [thc, rhc], keyboard: { held } } as never);
  rhc.reading.axes = [0, 1, 0, 0];
  inHand.look();
  expect([inHand.short('+pitch'), inHand.short('+X')]).toEqual(['L↑', 'L↑']);
  thc.state = 'lost';
  inHand.look();
  expect([inHand.short('+pitch'), inHand.short('+X')]).toEqual(['L↑', 'W']);

  const mapping = DEFAULTS['thc joystick'];
  const joystick = {
    kind: 'thc joystick',
    state: 'flying',
    mapping,
    reading: { axes: [0, 0, 0, -1], buttons: [] },
  };
  const hand = new InHand({ devices: [joystick], keyboard: { held } } as never);
  hand.look();
  expect(hand.short('+X')).toBe('W');
  joystick.reading.axes = [0, -1, 0, -1];
  hand.look();
  expect(hand.short('+X')).toBe('1−');
});

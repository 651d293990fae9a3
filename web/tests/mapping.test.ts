import { expect, test } from 'vitest';
import { Capture } from '../src/input/capture';
import { DEFAULTS } from '../src/input/defaults';
import { AXES } from '../src/input/deflection';
import type { Reading } from '../src/input/device';
import { axisUse, USES } from '../src/input/keymap';
import { centred, KINDS, MOST_BINDINGS, parseMapping, shape, sourcesOf } from '../src/input/mapping';
import { bind, isFixed, keyRefusal, movers, unbind, zeroed } from '../src/input/rebind';
import { CAP_AT_REST, parsed } from '../src/input/spacemouse';
import { mappingOf, reread, restore, save } from '../src/input/store';

/** Values from least to most, both included. */
function steps(least: number, most: number, count: number): readonly number[] {
  return Array.from({ length: count + 1 }, (_, i) => least + ((most - least) * i) / count);
}

const SETTINGS = steps(0, 0.5, 5).flatMap((deadband) => steps(0, 1, 4).map((expo) => ({ deadband, expo })));

test('deadband and expo are monotone, odd, and take 0 to 0 and 1 to 1', () => {
  for (const setting of SETTINGS) {
    expect(Object.is(shape(0, setting), 0)).toBe(true);
    expect(shape(1, setting)).toBeCloseTo(1, 12);
    let before = -1;
    for (const value of steps(-1, 1, 400)) {
      const shaped = shape(value, setting);
      expect(shaped).toBeGreaterThanOrEqual(before - 1e-12);
      expect(shape(-value, setting) + shaped).toBeCloseTo(0, 12);
      if (Math.abs(value) <= setting.deadband) expect(shaped).toBe(0);
      before = shaped;
    }
  }
});

test('an axis that rests off centre reaches both ends, and zero where it rests', () => {
  for (const centre of steps(-0.3, 0.3, 12)) {
    expect(centred(centre, centre)).toBe(0);
    expect([centred(-1, centre), centred(1, centre)]).toEqual([-1, 1]);
    let before = -2;
    for (const raw of steps(-1.2, 1.2, 200)) {
      const value = centred(raw, centre);
      expect(value).toBeGreaterThanOrEqual(before);
      before = value;
    }
  }
});

test('every mapping that the station comes with is one, and names only what can be done', () => {
  for (const kind of KINDS) {
    expect(parseMapping(JSON.parse(JSON.stringify(DEFAULTS[kind])))).toEqual(DEFAULTS[kind]);
    expect(Object.keys(DEFAULTS[kind].bindings).length).toBeLessThanOrEqual(MOST_BINDINGS);
  }
});

test('every axis has a key for either side, and every action has one', () => {
  const { bindings } = DEFAULTS.keyboard;
  const bound = new Set(Object.values(bindings));
  for (const axis of AXES.keys()) for (const sign of [1, -1]) expect(bound).toContain(axisUse(axis, sign));
  for (const use of USES.keys()) expect(bound).toContain(use);
});

test('any key put to any use is there after JSON, and its former keys are free', () => {
  const mapping = DEFAULTS.keyboard;
  for (const use of USES.keys()) {
    if (isFixed('keyboard', use)) continue;
    const changed = bind('keyboard', mapping, use, { source: 'Numpad7', sign: 1 });
    const back = parseMapping(JSON.parse(JSON.stringify(changed)));
    expect(back).toEqual(changed);
    expect(sourcesOf(back, use)).toEqual(['Numpad7']);
    const others = Object.entries(mapping.bindings).filter(([, its]) => its !== use);
    expect(Object.entries(back.bindings).filter(([, its]) => its !== use)).toEqual(others);
  }
});

test('a key with a use is refused for another one, and the sentence says which', () => {
  for (const [source, its] of Object.entries(DEFAULTS.keyboard.bindings)) {
    for (const use of ['+X', 'rate', 'close']) {
      const put = () => bind('keyboard', DEFAULTS.keyboard, use, { source, sign: 1 });
      if (its === use) expect(put).not.toThrow();
      else expect(put).toThrow(USES.get(its)?.label);
    }
  }
});

test('a stick moved away for +X is −X of its axis, and takes the place of both sides', () => {
  const free = unbind(DEFAULTS.pad, '+pitch');
  expect(sourcesOf(free, '-pitch')).toEqual([]);
  const changed = bind('pad', free, '+X', { source: 'a3', sign: -1 });
  expect(changed.bindings['a3']).toBe('-X');
  expect(changed.bindings['a1']).toBeUndefined();
  expect(movers(changed, '+X')).toEqual([{ source: 'a3', sign: -1 }]);
  expect(movers(changed, '-X')).toEqual([{ source: 'a3', sign: 1 }]);
});

test('an axis does nothing that needs a button, and one in use is refused', () => {
  expect(() => bind('pad', DEFAULTS.pad, 'rate', { source: 'a5', sign: 1 })).toThrow('needs a button');
  expect(() => bind('pad', DEFAULTS.pad, '+X', { source: 'a3', sign: 1 })).toThrow('RHC −pitch');
});

test('the browser keeps its keys, Space stops always', () => {
  const alone = { ctrlKey: false, altKey: false, metaKey: false };
  for (const code of [
    'Tab',
    'Backspace',
    'Slash',
    'Quote',
    'F1',
    'F5',
    'F12',
    'ShiftLeft',
    'AltRight',
    'MetaLeft',
  ]) {
    expect(keyRefusal({ code, ...alone })).toContain('belongs to the browser');
  }
  for (const part of ['ctrlKey', 'altKey', 'metaKey']) {
    expect(keyRefusal({ code: 'Insert', ...alone, [part]: true })).toContain('belong to the browser');
  }
  expect(keyRefusal({ code: 'Space', ...alone })).toContain('always stops');
  for (const code of ['Digit1', 'Numpad0', 'Insert', 'ArrowUp']) {
    expect(keyRefusal({ code, ...alone })).toBeNull();
  }
});

test('no key of the browser has a use from the beginning', () => {
  const alone = { ctrlKey: false, altKey: false, metaKey: false };
  for (const [code, use] of Object.entries(DEFAULTS.keyboard.bindings)) {
    if (!isFixed('keyboard', use)) expect(keyRefusal({ code, ...alone })).toBeNull();
  }
});

test('a malformed mapping is refused in words', () => {
  const good = DEFAULTS.pad;
  for (const [data, words] of [
    [null, 'object'],
    [{ ...good, deadband: 0.9 }, 'deadband'],
    [{ ...good, expo: Number.NaN }, 'expo'],
    [{ ...good, centres: [0.9] }, 'centre'],
    [{ ...good, bindings: { a0: 'fly away' } }, 'fly away'],
    [{ ...good, bindings: { 'rm -rf': '+X' } }, 'rm -rf'],
    [{ ...good, bindings: { a0: 'rate' } }, 'rate'],
  ] as const) {
    expect(() => parseMapping(data)).toThrow(words);
  }
});

test('an axis that stands too far off is not zeroed there; one that moves nothing is left alone', () => {
  expect(() => zeroed('thc joystick', DEFAULTS['thc joystick'], [0, 0, 0.8, -1])).toThrow('Axis 2');
  expect(zeroed('thc joystick', DEFAULTS['thc joystick'], [0.1, 0, 0, -1]).centres).toEqual([0.1, 0, 0, 0]);
});

test('what was saved is there when the page is opened again; what is broken is not used', () => {
  const kept = new Map<string, string>();
  const storage = {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => kept.set(key, value),
    removeItem: (key: string) => kept.delete(key),
  };
  Object.defineProperty(globalThis, 'localStorage', { value: storage, configurable: true });
  const mine = bind('keyboard', DEFAULTS.keyboard, '+X', { source: 'Numpad5', sign: 1 });
  save('keyboard', mine);
  reread();
  expect(mappingOf('keyboard')).toEqual(mine);
  restore('keyboard');
  reread();
  expect(mappingOf('keyboard')).toBe(DEFAULTS.keyboard);
  kept.set('aftdeck.controllers.pad', '{"bindings": 3}');
  expect(reread()).toEqual([expect.stringContaining('bindings')]);
  expect(mappingOf('pad')).toBe(DEFAULTS.pad);
  Reflect.deleteProperty(globalThis, 'localStorage');
  reread();
});

function look(axes: readonly number[], ...down: number[]): Reading {
  const buttons = Array.from({ length: 12 }, (_, i) => ({ pressed: down.includes(i), value: 0 }));
  return { axes, buttons };
}

test('what was moved is told by how far it went, wherever it rested', () => {
  const capture = new Capture(DEFAULTS.pad);
  expect(capture.look(look([0, -1]))).toBeNull();
  expect(capture.look(look([0.2, -0.8]))).toBeNull();
  expect(capture.look(look([0.2, -0.3]))).toEqual({ source: 'a1', sign: 1 });
});

test('a button held since before is not meant; Menu is, once it comes up alone', () => {
  const capture = new Capture(DEFAULTS.pad);
  capture.look(look([], 3));
  expect(capture.look(look([], 3, 9))).toBeNull();
  expect(capture.look(look([], 3))).toEqual({ source: 'b9', sign: 1 });
  const other = new Capture(DEFAULTS.pad);
  other.look(look([]));
  other.look(look([], 9));
  expect(other.look(look([], 9, 1))).toEqual({ source: 'b9+b1', sign: 1 });
});

function report(...values: number[]): DataView {
  const data = new DataView(new ArrayBuffer(2 * values.length));
  values.forEach((value, i) => {
    data.setInt16(2 * i, value, true);
  });
  return data;
}

test('a SpaceMouse tells its axes in two reports, or in one', () => {
  const two = parsed(CAP_AT_REST, 1, report(350, -175, 0));
  expect(two?.axes).toEqual([1, -0.5, 0, 0, 0, 0]);
  const turned = two && parsed(two, 2, report(0, 0, -350));
  expect(turned?.axes).toEqual([1, -0.5, 0, 0, 0, -1]);
  expect(parsed(CAP_AT_REST, 1, report(0, 0, 70, 0, 0, 700))?.axes).toEqual([0, 0, 0.2, 0, 0, 1]);
});

test('a SpaceMouse report that is too short or odd is not understood; others are passed over', () => {
  expect(parsed(CAP_AT_REST, 1, report(1, 2))).toBeNull();
  expect(parsed(CAP_AT_REST, 1, report(1, 2, 3, 4, 5))).toBeNull();
  expect(parsed(CAP_AT_REST, 2, new DataView(new ArrayBuffer(5)))).toBeNull();
  expect(parsed(CAP_AT_REST, 0x17, new DataView(new ArrayBuffer(1)))).toBe(CAP_AT_REST);
  const buttons = parsed(CAP_AT_REST, 3, new DataView(Uint8Array.of(2, 1).buffer))?.buttons;
  expect(buttons?.flatMap((down, i) => (down ? [i] : []))).toEqual([1, 8]);
});

test('the keyboard does everything that can be done', () => {
  const bound = new Set(Object.values(DEFAULTS.keyboard.bindings));
  expect([...USES.keys()].filter((use) => !bound.has(use))).toEqual([]);
});

import { expect, test } from 'vitest';
import { DEFAULTS } from '../src/input/defaults';
import { USES } from '../src/input/keymap';
import { parseMapping, sourcesOf } from '../src/input/mapping';
import { bind, exchange, isFixed, keyRefusal, movers, unbind, zeroed, zeroWords } from '../src/input/rebind';

test('a key can be assigned to any function, which then loses its former keys', () => {
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

test('a key that has a function is rejected; the error names this function', () => {
  for (const [source, its] of Object.entries(DEFAULTS.keyboard.bindings)) {
    for (const use of ['+X', 'rate', 'close']) {
      const put = () => bind('keyboard', DEFAULTS.keyboard, use, { source, sign: 1 });
      if (its === use) expect(put).not.toThrow();
      else expect(put).toThrow(USES.get(its)?.label);
    }
  }
});

test('a stick assigned to +X inverted replaces both sides of X', () => {
  const free = unbind(DEFAULTS.pad, '+pitch');
  expect(sourcesOf(free, '-pitch')).toEqual([]);
  const changed = bind('pad', free, '+X', { source: 'a3', sign: -1 });
  expect(changed.bindings['a3']).toBe('-X');
  expect(changed.bindings['a1']).toBeUndefined();
  expect(movers(changed, '+X')).toEqual([{ source: 'a3', sign: -1 }]);
  expect(movers(changed, '-X')).toEqual([{ source: 'a3', sign: 1 }]);
});

test('a used key is exchanged: its function has the former keys of the other one', () => {
  const mapping = DEFAULTS.keyboard;
  for (const [source, its] of Object.entries(mapping.bindings)) {
    for (const use of ['+X', 'rate', 'close']) {
      if (its === use || isFixed('keyboard', its)) continue;
      const changed = exchange('keyboard', mapping, use, { source, sign: 1 });
      expect(sourcesOf(changed, use)).toEqual([source]);
      expect(sourcesOf(changed, its)).toEqual(sourcesOf(mapping, use));
      expect(parseMapping(changed)).toEqual(changed);
    }
  }
});

test('exchanged sticks keep their directions; the other function of a free control has none', () => {
  const changed = exchange('pad', DEFAULTS.pad, '+X', { source: 'a3', sign: -1 });
  expect([changed.bindings['a3'], changed.bindings['a1']]).toEqual(['-X', '-pitch']);
  const inverted = exchange('pad', DEFAULTS.pad, '+X', { source: 'a3', sign: 1 });
  expect([inverted.bindings['a3'], inverted.bindings['a1']]).toEqual(['+X', '+pitch']);
  const given = exchange('pad', DEFAULTS.pad, 'safing', { source: 'b0', sign: 1 });
  expect(sourcesOf(given, 'rate')).toEqual([]);
});

test('an axis and a button cannot be exchanged', () => {
  const put = () => exchange('pad', DEFAULTS.pad, '+X', { source: 'b0', sign: 1 });
  expect(put).toThrow('South is already “coarse, vernier”, which cannot move to Left stick ↕');
});

test('an axis is rejected for a button function, and also if it already has another function', () => {
  expect(() => bind('pad', DEFAULTS.pad, 'rate', { source: 'a5', sign: 1 })).toThrow('needs a button');
  expect(() => bind('pad', DEFAULTS.pad, '+X', { source: 'a3', sign: 1 })).toThrow('RHC −pitch');
});

test('keys of the browser and Space cannot be assigned', () => {
  const alone = { ctrlKey: false, altKey: false, metaKey: false };
  for (const code of ['Tab', 'Backspace', 'Slash', 'Quote', 'F1', 'F5', 'F12', 'AltRight', 'MetaLeft']) {
    expect(keyRefusal({ code, ...alone })).toContain('belongs to the browser');
  }
  for (const part of ['ctrlKey', 'altKey', 'metaKey']) {
    expect(keyRefusal({ code: 'Insert', ...alone, [part]: true })).toContain('belong to the browser');
  }
  expect(keyRefusal({ code: 'Space', ...alone })).toContain('always stops');
  for (const code of ['Digit1', 'Numpad0', 'Insert', 'ArrowUp', 'ShiftLeft']) {
    expect(keyRefusal({ code, ...alone })).toBeNull();
  }
});

test('an axis too far off centre keeps its zero and is named; an unused one is ignored', () => {
  const before = { ...DEFAULTS['thc joystick'], centres: [0, 0.2, 0.05] };
  const { mapping, far } = zeroed(before, [0.1, 0, 0.8, -1]);
  expect([mapping.centres, far]).toEqual([[0.1, 0, 0.05, 0], ['a2']]);
  expect(zeroWords('thc joystick', far)).toContain('Axis 2');
  expect(zeroWords('thc joystick', [])).not.toContain('except');
});

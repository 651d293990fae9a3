import { expect, test } from 'vitest';
import { DEFAULTS } from '../src/input/defaults';
import { AXES } from '../src/input/deflection';
import { axisUse, USES } from '../src/input/keymap';
import { isFixed, keyRefusal } from '../src/input/rebind';

test('each axis side and each action has a default key', () => {
  const { bindings } = DEFAULTS.keyboard;
  const bound = new Set(Object.values(bindings));
  for (const axis of AXES.keys()) for (const sign of [1, -1]) expect(bound).toContain(axisUse(axis, sign));
  for (const use of USES.keys()) expect(bound).toContain(use);
});

test('no default key belongs to the browser', () => {
  const alone = { ctrlKey: false, altKey: false, metaKey: false };
  for (const [code, use] of Object.entries(DEFAULTS.keyboard.bindings)) {
    if (!isFixed('keyboard', use)) expect(keyRefusal({ code, ...alone })).toBeNull();
  }
});

test.each([
  ['KeyW', '+X'],
  ['KeyI', '+pitch'],
  ['KeyV', 'rate'],
  ['Equal', 'joint +'],
  ['KeyF', 'plane'],
  ['Period', 'cameraStep +'],
  ['KeyX', 'otherMonitor'],
  ['Digit1', 'camera 1'],
])('the key %s has the function %s', (code, use) => {
  expect(DEFAULTS.keyboard.bindings[code]).toBe(use);
});

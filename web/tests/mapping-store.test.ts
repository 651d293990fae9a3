import { expect, test } from 'vitest';
import { DEFAULTS } from '../src/input/defaults';
import { bind } from '../src/input/rebind';
import { mappingOf, reread, restore, save } from '../src/input/store';

test('a saved mapping is loaded again; a broken one is not used', () => {
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

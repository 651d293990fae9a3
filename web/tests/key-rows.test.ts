import { expect, test } from 'vitest';
import { DEFAULTS } from '../src/input/defaults';
import { isForCameras } from '../src/input/keyboard';
import { restore, save } from '../src/input/store';
import { stopOf } from '../src/page/key-rows';

const key = (pressed: string | null) => ({ getAttribute: () => pressed });

test('Tab stops at the key in focus, else at the pressed key, else at the first key', () => {
  const [first, second, third] = [key(null), key('true'), key('false')];
  const keys = [first, second, third];
  expect(stopOf(keys, third)).toBe(third);
  expect(stopOf(keys, null)).toBe(second);
  expect(stopOf([first, third], null)).toBe(first);
  expect(stopOf([], null)).toBeUndefined();
});

test('a row never takes an arrow key that has a function of the arm', () => {
  expect(isForCameras('ArrowLeft')).toBe(true);
  for (const use of ['-Y', '+telescope', 'brakes']) {
    save('keyboard', { ...DEFAULTS.keyboard, bindings: { ...DEFAULTS.keyboard.bindings, ArrowLeft: use } });
    expect(isForCameras('ArrowLeft'), use).toBe(false);
  }
  restore('keyboard');
});

import { expect, test } from 'vitest';
import { together } from '../src/panel/controllers/key-map';

test('names that begin alike are joined', () => {
  expect(together([])).toBe('');
  expect(together(['North'])).toBe('North');
  expect(together(['Menu + Cross ↓', 'Menu + Cross ↑'])).toBe('Menu + Cross ↓ ↑');
  expect(together(['Menu + North', 'Menu + Cross ↑'])).toBe('Menu + North Cross ↑');
  expect(together(['North', 'Menu + North'])).toBe('North, Menu + North');
});

import { expect, test } from 'vitest';
import { opposite } from '../src/panel/desk/thc';

test('the negative end of an axis has the opposite word', () => {
  expect(opposite('+X fwd')).toBe('−X aft');
  expect(opposite('+Z down')).toBe('−Z up');
  expect(opposite('+X')).toBe('−X');
});

import { expect, test } from 'vitest';
import { tornHere } from '../src/windows/opened';

test('the address selects what a secondary window shows', () => {
  expect(tornHere('')).toBeNull();
  expect(tornHere('?view=mon1')).toBe(0);
  expect(tornHere('?view=mon2&quality=low')).toBe(1);
  expect(tornHere('?view=matrix')).toBe('matrix');
  expect(tornHere('?view=else')).toBeNull();
});

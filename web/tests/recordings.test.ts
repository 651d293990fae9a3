import { expect, test } from 'vitest';
import { resultWords } from '../src/panel/rail/recordings';

test('a recording shows its length, and its end unless the operator ended it', () => {
  expect(resultWords({ time_s: 245.9, ended: 'completed', grade: 'A' })).toBe('4:05, completed, grade A');
  expect(resultWords({ time_s: 59, ended: 'stopped', grade: '' })).toBe('0:59');
  expect(resultWords({ time_s: 3600, ended: 'cut', grade: '' })).toBe('60:00, cut short');
  expect(resultWords({ time_s: null, ended: '', grade: '' })).toBe('');
});

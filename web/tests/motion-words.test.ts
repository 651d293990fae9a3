import { expect, test } from 'vitest';
import { motionWords } from '../src/words/motion-words';

test('mechanisms show the seconds that they still need, rounded up', () => {
  expect(motionWords([])).toBe('');
  const closing = { text: 'latches close', remaining_s: 12.02 };
  expect(motionWords([closing])).toBe('latches close, 13 s');
  expect(motionWords([closing, { text: 'snares open', remaining_s: 0.4 }])).toBe(
    'latches close, 13 s; snares open, 1 s',
  );
});

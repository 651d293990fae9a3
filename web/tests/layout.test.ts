import { expect, test } from 'vitest';
import { learnLetter, nameOf } from '../src/input/layout';

test('the letter of a key is learned when the key is pressed without a modifier', () => {
  const alone = { shiftKey: false, ctrlKey: false, altKey: false, metaKey: false };
  expect(nameOf('KeyQ')).toBe('Q');
  learnLetter({ ...alone, code: 'KeyQ', key: '!', shiftKey: true });
  learnLetter({ ...alone, code: 'KeyQ', key: 'Dead' });
  expect(nameOf('KeyQ')).toBe('Q');
  learnLetter({ ...alone, code: 'KeyQ', key: 'a' });
  learnLetter({ ...alone, code: 'KeyW', key: 'w' });
  expect([nameOf('KeyQ'), nameOf('KeyW')]).toEqual(['A', 'W']);
  learnLetter({ ...alone, code: 'KeyQ', key: 'q' });
  expect(nameOf('KeyQ')).toBe('Q');
});

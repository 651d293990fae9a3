import { expect, test } from 'vitest';
import { segments } from '../src/panel/spine/lamp-test';

test.each([
  ['−12.5', '±888.8'],
  ['356.5', '888.8'],
  ['−1282.5', '±8888.8'],
  ['+0.05', '±8.88'],
  ['000/03:42:17', '888/88:88:88'],
  ['–', '–'],
])('TEST shows %s as %s', (shown, lit) => {
  expect(segments(shown)).toBe(lit);
});

import { expect, test } from 'vitest';
import { LEAST, REST_MS, Rest } from '../src/cameras/rest';

test('pictures are at rest when nothing has changed for a time', () => {
  const rest = new Rest();
  expect(rest.look([1, 2], 'a', 1000)).toBe(false);
  expect(rest.look([1, 2], 'a', 1000 + REST_MS - 1)).toBe(false);
  expect(rest.look([1, 2], 'a', 1000 + REST_MS)).toBe(true);
  expect(rest.changes).toBe(1);
});

test.each<[string, readonly number[], string]>([
  ['a number', [1, 2 + LEAST], 'a'],
  ['the amount of numbers', [1], 'a'],
  ['the state', [1, 2], 'b'],
])('%s that changes ends the rest', (_, values, state) => {
  const rest = new Rest();
  rest.look([1, 2], 'a', 0);
  expect(rest.look(values, state, REST_MS)).toBe(false);
  expect(rest.changes).toBe(2);
  expect(rest.look(values, state, 2 * REST_MS)).toBe(true);
});

test('a change that no picture shows does not end the rest', () => {
  const rest = new Rest();
  rest.look([1, 2], 'a', 0);
  expect(rest.look([1, 2 + 0.9 * LEAST], 'a', REST_MS)).toBe(true);
  expect(rest.changes).toBe(1);
});

test('a slow motion is no rest, however often it is looked at', () => {
  const rest = new Rest();
  const speed = (2 * LEAST) / REST_MS;
  let rested = 0;
  for (let now = 0; now < 5000; now += 5) if (rest.look([speed * now], 'a', now)) rested += 1;
  expect(rested).toBe(0);
});

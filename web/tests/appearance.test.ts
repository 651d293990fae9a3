import { expect, test } from 'vitest';
import { Appearance, type Looks, looksOf } from '../src/page/appearance';

const kept = new Map<string, string>();
const store = {
  getItem: (key: string) => kept.get(key) ?? null,
  setItem: (key: string, value: string) => kept.set(key, value),
};

test('a look is off until it is chosen, and kept then; whoever shows it is told', () => {
  const told: Looks[] = [];
  const tell = (looks: Looks) => told.push(looks);
  new Appearance(store, tell).set({ early: true });
  new Appearance(store, tell).set({ night: true });
  new Appearance(store, tell).set({ early: false });
  expect(told.map(({ early, night }) => [early, night])).toEqual([
    [false, false],
    [true, false],
    [true, false],
    [true, true],
    [true, true],
    [false, true],
  ]);
});

test('what cannot be read is as new', () => {
  for (const text of [null, '', '{', '{"early": 1, "night": "yes"}'])
    expect(looksOf(text)).toEqual(looksOf(null));
});

import { expect, test } from 'vitest';
import { Appearance, type Looks, looksOf } from '../src/page/appearance';

const kept = new Map<string, string>();
const store = {
  getItem: (key: string) => kept.get(key) ?? null,
  setItem: (key: string, value: string) => kept.set(key, value),
};

test('a display option is off by default, stored, and reported to listeners', () => {
  const reported: Looks[] = [];
  const listener = (looks: Looks) => reported.push(looks);
  new Appearance(store, listener).set({ early: true });
  new Appearance(store, listener).set({ night: true });
  new Appearance(store, listener).set({ early: false });
  expect(reported.map(({ early, night }) => [early, night])).toEqual([
    [false, false],
    [true, false],
    [true, false],
    [true, true],
    [true, true],
    [false, true],
  ]);
});

test('the look of 1972 is stored for each monitor and the view of all cameras', () => {
  const appearance = new Appearance(store, () => {});
  expect(appearance.seventies).toEqual([false, false, false]);
  appearance.set({ seventies: [false, true, false] });
  expect(new Appearance(store, () => {}).seventies).toEqual([false, true, false]);
});

test('stored options that cannot be read are replaced by the defaults', () => {
  for (const text of [null, '', '{', '{"early": 1, "night": "yes", "seventies": [1]}', '{"seventies": true}'])
    expect(looksOf(text)).toEqual(looksOf(null));
});

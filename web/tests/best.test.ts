import { expect, test } from 'vitest';
import { type Best, bestOf, keepBest } from '../src/task/best';
import { bestWords } from '../src/task/debrief';

function keeperOf(store: Map<string, string>) {
  return {
    getItem: (key: string) => store.get(key) ?? null,
    setItem: (key: string, value: string) => void store.set(key, value),
  };
}

test('a better grade or a shorter time with the same grade is kept, and nothing else', () => {
  const keeper = keeperOf(new Map());
  const runs: readonly (readonly [Best, boolean])[] = [
    [{ grade: 'C', time: 90 }, true],
    [{ grade: 'D', time: 10 }, false],
    [{ grade: 'C', time: 90 }, false],
    [{ grade: 'C', time: 89.5 }, true],
    [{ grade: 'A', time: 400 }, true],
    [{ grade: 'B', time: 100 }, false],
  ];
  for (const [run, kept] of runs) expect(keepBest(keeper, 'tutorial', run), `${run.grade}`).toBe(kept);
  expect(bestOf(keeper, 'tutorial')).toEqual({ grade: 'A', time: 400 });
  expect(bestOf(keeper, 'loaded')).toBeNull();
});

test('a stored text that is no result counts as none', () => {
  for (const text of ['', 'A', 'E 10', 'A ten', 'A -1', 'AB 10'])
    expect(bestOf(keeperOf(new Map([['aftdeck.best.x', text]])), 'x')).toBeNull();
});

test('the words compare with the best run before', () => {
  expect(bestWords(null, true)).toBe('Your first run');
  expect(bestWords({ grade: 'B', time: 125 }, false)).toBe('Your best run: B, 2 min 5 s');
  expect(bestWords({ grade: 'B', time: 125 }, true)).toContain('before: B, 2 min 5 s');
});

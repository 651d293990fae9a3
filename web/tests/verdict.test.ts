import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import type { Verdict } from '../src/link/protocol';
import { pollVerdict } from '../src/replay/verdict';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

const verdict = (state: Verdict['state']) => ({ state, text: '' }) as Verdict;

it('the result is requested until it is complete, also after a failed request', async () => {
  const answers = [
    Promise.resolve(verdict('checking')),
    Promise.reject(new Error('no answer')),
    Promise.resolve(verdict('equal')),
  ];
  answers[1]?.catch(() => {});
  const shown: string[] = [];
  let asked = 0;
  pollVerdict(
    {
      verdict: () => answers[asked++] ?? Promise.reject(new Error('asked again')),
    },
    ({ state }) => shown.push(state),
  );
  await vi.advanceTimersByTimeAsync(60_000);
  expect(shown).toEqual(['checking', 'equal']);
  expect(asked).toBe(3);
});

it('a source that has no result is asked once', async () => {
  let asked = 0;
  const verdict = () => {
    asked += 1;
    return null;
  };
  pollVerdict({ verdict }, () => expect.unreachable());
  await vi.advanceTimersByTimeAsync(60_000);
  expect(asked).toBe(1);
});

import { expect, test } from 'vitest';
import { Arrivals } from '../src/link/arrivals';
import type { Readiness } from '../src/link/protocol';
import { waitingText } from '../src/page/readiness';
import { link, sent } from './sent-frames';

const READY: Readiness = { type: 'readiness', waits_for: '', share: null, left_s: null, failure: '' };

test('a run that goes on has no notice', () => {
  expect(waitingText(READY)).toBe('');
  expect(waitingText({ ...READY, share: 0.5, left_s: 31 })).toBe('');
});

test('a run that waits says for what, and how long', () => {
  expect(waitingText({ ...READY, waits_for: 'page' })).not.toBe('');
  const half: Readiness = { ...READY, waits_for: 'laws', share: 0.5, left_s: 31 };
  expect(waitingText(half)).toContain('31 s');
  expect(waitingText({ ...half, left_s: null })).not.toContain('null');
});

test('while the run stands still, its last frame is not old', () => {
  const arrivals = new Arrivals(link());
  arrivals.put(sent(1), 1000);
  arrivals.stands = true;
  arrivals.unseen(9000);
  expect(arrivals.silence(9000)).toBe(0);
  expect(arrivals.age('telemetry', 9000).s).toBe(0);
  arrivals.stands = false;
  expect(arrivals.silence(9000)).toBe(8);
});

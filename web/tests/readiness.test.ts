import { expect, test } from 'vitest';
import { Arrivals } from '../src/link/delayed-messages';
import type { Frame, Readiness } from '../src/link/protocol';
import { readinessText } from '../src/page/readiness';

const READY: Readiness = { type: 'readiness', waits_for: '', share: null, left_s: null, failure: '' };

test('nothing is said when all is ready', () => {
  expect(readinessText(READY)).toBe('');
});

test('the time left is named, while the arm flies and while the run waits', () => {
  const half = { ...READY, share: 0.5, left_s: 31 };
  expect(readinessText(half)).toContain('31 s');
  expect(readinessText({ ...half, waits_for: 'laws' })).toContain('31 s');
  expect(readinessText({ ...half, left_s: null })).not.toContain('null');
});

test('a failure is named with its consequence', () => {
  expect(readinessText({ ...READY, failure: 'the memory is full' })).toMatch(
    /look-ahead.*the memory is full/,
  );
});

test('while the run stands still, its last frame is not old', () => {
  const arrivals = new Arrivals({ command_delay_s: 0, telemetry_delay_s: 0, camera_delay_s: 0 });
  arrivals.put({ tick: 1, time_s: 0.02 } as Frame, 1000);
  arrivals.stands = true;
  arrivals.unseen(9000);
  expect(arrivals.silence(9000)).toBe(0);
  expect(arrivals.age('telemetry', 9000).s).toBe(0);
  arrivals.stands = false;
  expect(arrivals.silence(9000)).toBe(8);
});

import { expect, test } from 'vitest';
import { KEYS } from '../src/input/active-device';
import type { WayOut } from '../src/link/protocol';
import { barred, moving, rateHoldHint } from '../src/task/state-words';
import { toGo } from './worksite';

const way = (cause: string): WayOut => ({
  cause,
  stick: 'translation',
  axis: 0,
  sign: -1,
  position: '',
  text: '',
});
const said = (inhibited: boolean, ways: readonly WayOut[]) =>
  barred({ work: { arm_inhibit: inhibited }, ways_out: ways }, [], KEYS)
    .map(({ text }) => text)
    .join('');

test('an inhibited arm is named with the ways out of the contact, and only with those', () => {
  expect(said(false, [way('contact')])).toBe('');
  expect(said(true, [way('elbow'), way('contact')])).toContain('THC −X (S)');
  expect(said(true, [way('elbow')])).not.toContain('THC');
  expect(said(true, [])).not.toBe('');
});

test('mechanisms in motion are named with their whole seconds', () => {
  expect(moving([])).toEqual([]);
  const [piece] = moving([{ text: 'latches open', remaining_s: 11.2 }]);
  expect(piece?.text).toContain('latches open, 12 s');
});

test('RATE HOLD is offered for a leg of more than 20 s unless the text names it, and its end while it is on', () => {
  const leg = (distance: number, speed: number, rate_hold = false, uses: readonly string[] = []) =>
    rateHoldHint(
      { rate_hold, por_limits: [speed, 1], display: { to_go: { ...toGo({}), distance } } },
      uses,
    ).map(({ kind, text }) => (kind === 'use' ? text : ''));
  expect(leg(21, 1)).toContain('rate hold');
  expect(leg(2.1, 0.1)).toContain('rate hold');
  expect(leg(20, 1)).toEqual([]);
  expect(leg(21, 1, true)).toEqual(['', 'stop', '']);
  expect(leg(21, 1, false, ['rate hold'])).toEqual([]);
  expect(leg(21, 0)).toEqual([]);
  expect(rateHoldHint({ rate_hold: false, por_limits: [1, 1], display: { to_go: null } }, [])).toEqual([]);
});

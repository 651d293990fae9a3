import { expect, test } from 'vitest';
import { KEYS } from '../src/input/active-device';
import type { WayOut } from '../src/link/protocol';
import { barred, moving } from '../src/task/state-words';

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

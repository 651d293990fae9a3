import { expect, test } from 'vitest';
import { KEYS } from '../src/input/active-device';
import type { WayOut } from '../src/link/protocol';
import { wayOutText } from '../src/words/way-out';

const WAY: WayOut = { cause: 'contact', text: '', stick: 'translation', axis: 2, sign: -1, position: '' };

test('a stick direction has its mode and key', () => {
  expect(wayOutText(WAY, '', KEYS)).toBe('THC −Z (Q)');
  expect(wayOutText({ ...WAY, position: 'ORB UNL' }, '', KEYS)).toBe('ORB UNL, THC −Z (Q)');
  expect(wayOutText({ ...WAY, stick: 'rotation', axis: 0, sign: 1 }, '', KEYS)).toBe('RHC +roll (O)');
});

test('an escape direction by a joint names its mode; an escape direction by the telescope has no mode', () => {
  const joint: WayOut = { ...WAY, stick: 'joint', axis: 2, position: 'SINGLE' };
  expect(wayOutText(joint, 'elbow pitch', KEYS)).toBe('SINGLE elbow pitch −');
  expect(wayOutText(joint, '', KEYS)).toBe('SINGLE −');
  expect(wayOutText({ ...WAY, stick: 'telescope', axis: 0, sign: 1 }, '', KEYS)).toBe('telescope longer');
});

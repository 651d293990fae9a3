import { expect, test } from 'vitest';
import { KEYS } from '../src/input/active-device';
import { leadsAway } from '../src/panel/desk/limits';

test('the escape direction of a joint past a limit names the joint once', () => {
  const way = {
    cause: 'elbow_pitch',
    stick: 'translation',
    axis: 2,
    sign: 1,
    position: '',
    text: '',
  } as const;
  expect(leadsAway(way, KEYS)).toBe('Elbow pitch: THC +Z (E) leads away');
  const single = { ...way, stick: 'joint', sign: -1, position: 'SINGLE' } as const;
  expect(leadsAway(single, KEYS)).toBe('Elbow pitch: SINGLE − leads away');
});

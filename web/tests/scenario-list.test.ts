import { expect, test } from 'vitest';
import { leaving } from '../src/panel/rail/scenarios';

test('the question before a change of scenario names the recording', () => {
  expect(leaving('First flight', 'Tutorial', true)).toBe(
    'Leave “First flight” for “Tutorial”? The recording of this run is kept.',
  );
  expect(leaving('First flight', 'Tutorial', false)).toContain('not recorded');
});

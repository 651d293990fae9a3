import { expect, test } from 'vitest';
import type { Condition } from '../src/link/protocol';
import { conditionText } from '../src/words/condition-text';
import { unitsOf } from '../src/words/units';

const [FEET, SI] = [unitsOf('ft-in'), unitsOf('SI')];

function condition(
  words: string,
  numbers: readonly number[],
  unit: Condition['unit'],
  holds = false,
): Condition {
  return { name: '', holds, value: 0, limit: 0, unit, margin: 0, words, numbers };
}

test('numbers are in the operator’s units; a range has one unit', () => {
  const palm = condition('palm {} above the bar, {} to {} allowed', [1.231, 0, 0.01905], 'm');
  expect(conditionText(palm, SI)).toBe('palm 123 cm above the bar, 0 to 1.91 cm allowed');
  expect(conditionText(palm, FEET)).toBe('palm 48.5 in above the bar, 0 to 0.75 in allowed');
  const bar = condition('bar {} clear of the palm, {} to {} allowed', [1.2, -0.02, 0.035], 'm');
  expect(conditionText(bar, FEET)).toBe('bar 47.2 in clear of the palm, −0.787 to 1.38 in allowed');
});

test('angles are in degrees, speeds in small units, counts without a unit', () => {
  const pitch = condition('pitch −{}, at most {} allowed', [0.2182, 0.1745], 'rad');
  expect(conditionText(pitch, SI)).toBe('pitch −12.5°, at most 10° allowed');
  const speed = condition('{}, at most {} allowed', [0.06096, 0.03048], 'm/s');
  expect(conditionText(speed, SI)).toBe('6.1 cm/s, at most 3.05 cm/s allowed');
  expect(conditionText(condition('{} trunnions in their guides', [2], ''), SI)).toBe(
    '2 trunnions in their guides',
  );
});

test('only the numbers that look alike get more figures, and only some', () => {
  const seat = condition('{} below its seat, {} to {} allowed', [0.0000001, 0, 0.51], 'm');
  expect(conditionText(seat, FEET)).toBe('0.000004 in below its seat, 0 to 20.1 in allowed');
  const less = condition('{} below its seat, {} to {} allowed', [1e-12, 0, 0.51], 'm');
  expect(conditionText(less, FEET)).toBe('0 in below its seat, 0 to 20.1 in allowed');
});

test('a text without a number is unchanged', () => {
  expect(conditionText(condition('bar behind the palm, none allowed', [], 'm'), SI)).toBe(
    'bar behind the palm, none allowed',
  );
});

test('the text of a failed value differs from the text of its limit', () => {
  const palm = condition('palm {} above the bar, {} to {} allowed', [0.0190551, 0, 0.01905], 'm');
  const [value, limit] = conditionText(palm, SI).match(/1\.\d+/g) ?? [];
  expect(Number(value)).toBeGreaterThan(Number(limit));
});

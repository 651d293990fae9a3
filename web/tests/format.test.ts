import { expect, test } from 'vitest';
import { attitude, clock, degrees, fixed, missionTime, parseNumber, timeCode } from '../src/words/format';

test('a number has a sign, fixed decimals and a minus character', () => {
  expect(fixed(1.26, 1)).toBe('+1.3');
  expect(fixed(-953.84, 1)).toBe('−953.8');
  expect(fixed(12.5, 1, false)).toBe('12.5');
});

test('zero never has a minus', () => {
  expect(fixed(-0.004, 2)).toBe('+0.00');
  expect(fixed(-0, 1, false)).toBe('0.0');
});

test('an attitude is from 0.0 to 359.9 degrees', () => {
  expect(attitude(-Math.PI / 2)).toBe('270.0');
  expect(attitude(2 * Math.PI - 1e-9)).toBe('0.0');
  expect(attitude(Math.PI)).toBe('180.0');
});

test('angles are shown in degrees', () => {
  expect(degrees(-Math.PI / 4)).toBe('−45.0');
  expect(degrees(Math.PI / 3, 1, false)).toBe('60.0');
});

test('times have the format of the panel', () => {
  expect(missionTime(3 * 86400 + 2 * 3600 + 17)).toBe('003/02:00:17');
  expect(timeCode(61.239)).toBe('00:01:01.23');
  expect(timeCode(0.07)).toBe('00:00:00.07');
  expect(clock(59.99)).toBe('00:00:59');
});

test.each([
  ['-953.7', -953.7],
  ['−953.7', -953.7],
  [' +12 ', 12],
  ['.5', 0.5],
  ['', null],
  ['12 in', null],
  ['1e3', null],
  ['--1', null],
])('the keyed-in text %j is read as %j', (text, value) => {
  expect(parseNumber(text)).toBe(value);
});

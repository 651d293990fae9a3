import { expect, test } from 'vitest';
import { figure, minutes, withUnit } from '../src/replay/quantity';
import { began, drawnRate } from '../src/replay/rail';
import { unitsOf } from '../src/words/units';

test('a distance is shown with its angle if it has one', () => {
  const measure = {
    name: '',
    quantity: 'gap',
    value: 0.021,
    text: '',
    about: '',
    angle: Math.PI / 180,
    level: 'info',
  } as const;
  expect(figure(measure, unitsOf('SI'))).toBe('2.1 cm, 1.0°');
  expect(figure({ ...measure, angle: null }, unitsOf('ft-in'))).toBe('0.8 in');
});

test('times and values have their units', () => {
  expect(minutes(297.4, 2)).toBe('04:57.40');
  expect(minutes(3725)).toBe('1:02:05');
  expect(withUnit('speed', 0.3048, unitsOf('ft-in'))).toBe('1.00 ft/s');
  expect(withUnit('speed', 0.3048, unitsOf('SI'))).toBe('0.30 m/s');
  expect(withUnit('angle', -Math.PI / 2, unitsOf('SI'))).toBe('−90.0°');
  expect(withUnit('share', 0.314, unitsOf('SI'))).toBe('31 %');
  expect(withUnit('distance', null, unitsOf('SI'))).toBe('–');
  expect(drawnRate({ period_s: 0.02, stride: 10 })).toBe('Drawn 5 times a second');
  expect(drawnRate({ period_s: 0.02, stride: 20 })).toBe('Drawn 2.5 times a second');
  expect(drawnRate({ period_s: 0.02, stride: 100 })).toBe('Drawn every 2.0 s');
  expect(began('2026-03-01T14:05:09.123+00:00')).toBe('2026-03-01 14:05 UTC');
});

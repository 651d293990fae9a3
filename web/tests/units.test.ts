import { expect, test } from 'vitest';
import { unitsOf } from '../src/words/units';

test('units are inches and feet per second, or SI', () => {
  expect(unitsOf('ft-in').length.perSi * 0.0254).toBeCloseTo(1);
  expect(unitsOf('ft-in').speed.perSi * 0.3048).toBeCloseTo(1);
  expect(unitsOf('SI').length.perSi).toBe(1);
});

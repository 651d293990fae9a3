import { expect, it } from 'vitest';
import { ShownUnits } from '../src/words/units';

it('units change between SI and feet and inches', () => {
  const shown = new ShownUnits('SI');
  expect(shown.units.length.name).toBe('m');
  shown.toggle();
  expect([shown.name, shown.units.length.name]).toEqual(['ft-in', 'in']);
  shown.toggle();
  expect(shown.name).toBe('SI');
});

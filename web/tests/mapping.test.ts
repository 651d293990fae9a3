import { expect, test } from 'vitest';
import { DEFAULTS } from '../src/input/defaults';
import { centred, KINDS, MOST_BINDINGS, parseMapping, shape } from '../src/input/mapping';

/** Returns `count` + 1 equally spaced values, from `least` to `most`, with both ends included. */
function steps(least: number, most: number, count: number): readonly number[] {
  return Array.from({ length: count + 1 }, (_, i) => least + ((most - least) * i) / count);
}

const SETTINGS = steps(0, 0.5, 5).flatMap((deadband) => steps(0, 1, 4).map((expo) => ({ deadband, expo })));

test('deadband and expo are monotone and odd, and map 0 to 0 and 1 to 1', () => {
  for (const setting of SETTINGS) {
    expect(Object.is(shape(0, setting), 0)).toBe(true);
    expect(shape(1, setting)).toBeCloseTo(1, 12);
    let before = -1;
    for (const value of steps(-1, 1, 400)) {
      const shaped = shape(value, setting);
      expect(shaped).toBeGreaterThanOrEqual(before - 1e-12);
      expect(shape(-value, setting) + shaped).toBeCloseTo(0, 12);
      if (Math.abs(value) <= setting.deadband) expect(shaped).toBe(0);
      before = shaped;
    }
  }
});

test('an axis that rests off centre is zero at rest, and reaches both ends', () => {
  for (const centre of steps(-0.3, 0.3, 12)) {
    expect(centred(centre, centre)).toBe(0);
    expect([centred(-1, centre), centred(1, centre)]).toEqual([-1, 1]);
    let before = -2;
    for (const raw of steps(-1.2, 1.2, 200)) {
      const value = centred(raw, centre);
      expect(value).toBeGreaterThanOrEqual(before);
      before = value;
    }
  }
});

test('each default mapping is valid', () => {
  for (const kind of KINDS) {
    expect(parseMapping(JSON.parse(JSON.stringify(DEFAULTS[kind])))).toEqual(DEFAULTS[kind]);
    expect(Object.keys(DEFAULTS[kind].bindings).length).toBeLessThanOrEqual(MOST_BINDINGS);
  }
});

test('the error for an invalid mapping names what is invalid', () => {
  const good = DEFAULTS.pad;
  for (const [data, words] of [
    [null, 'object'],
    [{ ...good, deadband: 0.9 }, 'deadband'],
    [{ ...good, expo: Number.NaN }, 'expo'],
    [{ ...good, centres: [0.9] }, 'centre'],
    [{ ...good, bindings: { a0: 'fly away' } }, 'fly away'],
    [{ ...good, bindings: { 'rm -rf': '+X' } }, 'rm -rf'],
    [{ ...good, bindings: { a0: 'rate' } }, 'rate'],
  ] as const) {
    expect(() => parseMapping(data)).toThrow(words);
  }
});

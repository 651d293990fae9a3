import { expect, test } from 'vitest';
import { expected } from '../src/scene/trial';

/** A renderer that takes `fixed` ms for a picture and `each` ms for a pixel. */
const tried = (fixed: number, each: number, area: number) => ({ area, ms: fixed + each * area });

test.each([
  [5, 1e-5],
  [300, 1e-3],
  [0, 2e-3],
])('a picture of a renderer with fixed costs of %d ms and %d ms a pixel is foreseen', (fixed, each) => {
  const area = 1280 * 720;
  const [small, large] = [256, 65_536].map((size) => tried(fixed, each, size)) as [
    ReturnType<typeof tried>,
    ReturnType<typeof tried>,
  ];
  expect(expected(small, large, area)).toBeCloseTo(fixed + each * area, 6);
});

test('a large picture is never expected to be faster than a small one', () => {
  expect(expected({ area: 256, ms: 30 }, { area: 65_536, ms: 20 }, 1e6)).toBe(30);
  expect(expected({ area: 256, ms: 30 }, { area: 65_536, ms: 40 }, 100)).toBe(30);
});

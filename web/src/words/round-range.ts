/** Range of a scale. Its ends are round numbers in the displayed unit, so that the scale rarely changes. */

/** Greatest number of steps of a range. */
const MOST_STEPS = 5;
const ROUND = [1, 2, 5, 10];

/** Returns the smallest round range that contains both values [SI]; `perSi`: displayed value of one SI unit. */
export function roundRange(low: number, high: number, perSi: number): readonly [number, number] {
  const size = (high - low || Math.abs(high) || 1) * perSi;
  const least = size / MOST_STEPS;
  const ten = 10 ** Math.floor(Math.log10(least));
  const step = ten * (ROUND.find((each) => each * ten >= least * (1 - 1e-9)) ?? 10);
  const from = Math.floor((low * perSi) / step + 1e-9);
  const to = Math.max(Math.ceil((high * perSi) / step - 1e-9), from + 1);
  return [(from * step) / perSi, (to * step) / perSi];
}

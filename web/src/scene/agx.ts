/** Tone map of the full profile for grey light, AgX as in three.js, and the inverse map. */

const [DARKEST, BRIGHTEST] = [-12.47393, 4.026069];
/** Coefficients of AgX's contrast curve. AgX's colour matrices are omitted: they leave grey unchanged. */
const CONTRAST = [-0.00232, 0.1191, 0.4298, -6.868, 31.96, -40.14, 15.5] as const;
const GAMMA = 2.2;

/** Returns the displayed value (linear, 0 to 1) of `light`, the product of light and exposure. */
export function agx(light: number): number {
  const stops = Math.log2(Math.max(light, 1e-10));
  const x = Math.min(1, Math.max(0, (stops - DARKEST) / (BRIGHTEST - DARKEST)));
  return (
    Math.max(
      0,
      CONTRAST.reduceRight((sum, factor) => sum * x + factor, 0),
    ) ** GAMMA
  );
}

/** For each byte, 0 to 255: least product of light and exposure that is displayed as this byte or a greater one. */
export const LIGHT_OF: readonly number[] = (() => {
  const found: number[] = [];
  let [low, high] = [0, 0];
  for (let byte = 0; byte < 256; byte++) {
    const shown = linear(byte / 255);
    [low, high] = [DARKEST, BRIGHTEST];
    for (let i = 0; i < 30; i++) {
      const middle = (low + high) / 2;
      if (agx(2 ** middle) < shown) low = middle;
      else high = middle;
    }
    found.push(byte === 0 ? 0 : 2 ** high);
  }
  return found;
})();

/** Returns the linear value of an sRGB value, by sRGB's transfer function. */
function linear(value: number): number {
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}

/** Lengths and speeds in the station's words, told in the operator's units. */

import type { Units } from './units';

/** SI size of each unit that such words have. */
const SIZES = { in: 0.0254, ft: 0.3048, mm: 1e-3, m: 1, 'ft/s': 0.3048, 'm/s': 1 } as const;
const MEASURE = /([\d.]+)(?: to (−?)([\d.]+))? (ft\/s|m\/s|in|ft|mm|m)(?![\w/])/g;
/** Figures of a number; more, where the words have more to tell a value from its limit. */
const FIGURES = 3;
const MOST_DECIMALS = 3;

/** `palm 4.04 ft above the bar, 0 to 0.75 in allowed` as `palm 123 cm above the bar, 0 to 1.91 cm allowed`. */
export function inUnits(text: string, { gap, creep }: Units): string {
  const told = [...text.matchAll(MEASURE)].flatMap(([, a, , b]) => [figuresOf(a), figuresOf(b)]);
  const figures = Math.max(FIGURES, ...told);
  return text.replace(
    MEASURE,
    (as, first: string, minus: string | undefined, last: string | undefined, name: keyof typeof SIZES) => {
      const unit = name.endsWith('/s') ? creep : gap;
      if (name === unit.name) return as;
      const per = SIZES[name] * unit.perSi;
      const end = last === undefined ? '' : ` to ${minus ?? ''}${shown(Number(last) * per, figures)}`;
      return `${shown(Number(first) * per, figures)}${end} ${unit.name}`;
    },
  );
}

/** A number, not negative, without zeros at its end. */
function shown(value: number, figures: number): string {
  const before = value > 0 ? Math.floor(Math.log10(value)) + 1 : 0;
  return String(Number(value.toFixed(Math.min(MOST_DECIMALS, Math.max(0, figures - before)))));
}

function figuresOf(number = ''): number {
  return number.replace('.', '').replace(/^0+/, '').length;
}

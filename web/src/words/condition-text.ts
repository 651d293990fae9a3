/** Text of a condition in the operator's units: its template with the numbers inserted. */

import type { Condition } from '../link/protocol';
import { fixed } from './format';
import type { Units } from './units';

const DEGREE = 180 / Math.PI;
/**
 * Significant figures of each number. If the value and a limit that it violates would have the same text, both get more
 * figures, up to `MOST_FIGURES`.
 */
const FIGURES = 3;
const MOST_FIGURES = 6;
/** Greatest number of decimals of a number with `FIGURES` figures. Each further figure allows one more decimal. */
const DECIMALS = 3;

/** Returns the text of a condition in these units, such as `palm 123 cm above the bar, 0 to 1.91 cm allowed`. */
export function conditionText(condition: Condition, units: Units): string {
  const { words, holds } = condition;
  const short = numbersOf(condition, units, FIGURES);
  let numbers = short;
  for (let figures = FIGURES + 1; !holds && figures <= MOST_FIGURES; figures += 1) {
    if (!numbers.slice(1).includes(numbers[0] ?? '')) break;
    const more = numbersOf(condition, units, figures);
    numbers = short.map((text, i) => (text === short[0] ? (more[i] ?? text) : text));
  }
  return filled(words, numbers, suffix(condition, units));
}

/** Returns the template with numbers in place of `{}`. In a range, only the second number has the unit. */
function filled(words: string, numbers: readonly string[], unit: string): string {
  const [first = '', ...parts] = words.split('{}');
  const rest = parts.map((part, i) => `${numbers[i] ?? ''}${part === ' to ' ? '' : unit}${part}`);
  return first + rest.join('');
}

function numbersOf({ numbers, unit }: Condition, units: Units, figures: number): readonly string[] {
  return numbers.map((number) => {
    const value = number * scale(unit, units);
    const before = value === 0 ? 0 : Math.floor(Math.log10(Math.abs(value))) + 1;
    const decimals = Math.min(DECIMALS + figures - FIGURES, Math.max(0, figures - before));
    return fixed(Number(value.toFixed(decimals)), decimals, false)
      .replace(/(\.\d*?)0+$/, '$1')
      .replace(/\.$/, '');
  });
}

function scale(unit: Condition['unit'], { gap, creep }: Units): number {
  switch (unit) {
    case 'm':
      return gap.perSi;
    case 'm/s':
      return creep.perSi;
    case 'rad':
    case 'rad/s':
      return DEGREE;
    case 's':
    case '':
      return 1;
  }
}

function suffix({ unit }: Condition, { gap, creep }: Units): string {
  switch (unit) {
    case 'm':
      return ` ${gap.name}`;
    case 'm/s':
      return ` ${creep.name}`;
    case 'rad':
      return '°';
    case 'rad/s':
      return '°/s';
    case 's':
      return ' s';
    case '':
      return '';
  }
}

/** Conditions that the operator meets last: the depth after the alignment, closed fingers when the palm is at the bar. */
const LAST: ReadonlySet<string> = new Set(['pin depth', 'prong closed']);

/** Returns the text of the condition to meet first of those that fail; empty if all hold. */
export function failureText(conditions: readonly Condition[], units: Units): string {
  const fails = conditions.filter(({ holds }) => !holds);
  const first = fails.find(({ name }) => !LAST.has(name)) ?? fails[0];
  return first ? conditionText(first, units) : '';
}

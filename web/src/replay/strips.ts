/** Strips: curves of quantities over the run, with the values at the playhead. */

import type { Curve, Strip } from '../link/protocol';
import { el, setClass, setStyle, setText, svg } from '../panel/parts/dom';
import type { Units } from '../words/units';
import { placeAt, stretched } from './lanes';
import { shown, withUnit } from './quantity';
import { partOf, type Span } from './span';

/** Margin above and below the curves, as a fraction of their range. */
const MARGIN = 0.08;
/** Half the height of the tag with the value. The tag stays within its strip. */
const HALF_TAG = '0.6rem';

export interface StripRow {
  readonly element: HTMLElement;
  /** Draws the playhead at the time `position` [s], and the curves' values; `word` is written after the last value. */
  at(position: number, values: readonly (number | null)[], word: string, units: Units): void;
}

/** Returns a curve as an SVG path: x is time [s], y is `height(value)`. Missing values are gaps. */
export function path({ times_s, values }: Curve, height: (value: number) => number): string {
  let pen = 'M';
  let text = '';
  values.forEach((value, i) => {
    if (value === null) {
      pen = 'M';
      return;
    }
    text += `${pen}${times_s[i]} ${height(value).toFixed(4)}`;
    pen = 'L';
  });
  return text;
}

/** Returns the function from a value to its position in the strip: 0 at the top, 1 at the bottom. */
export function heights({ low, high, limit }: Strip): (value: number) => number {
  const top = limit !== null && high > limit / 2 ? Math.max(high, limit) : high;
  const range = top - low || Math.abs(top) || 1;
  return (value) => (1 + MARGIN - (value - low) / range) / (1 + 2 * MARGIN);
}

/** Returns the reference values of a strip, each with the class of its line. */
export function boundsOf({ limit, caution, warning }: Pick<Strip, 'limit' | 'caution' | 'warning'>) {
  const all = [
    { level: 'limit', value: limit },
    { level: 'caution', value: caution },
    { level: 'warning', value: warning },
  ];
  return all.flatMap(({ level, value }) => (value === null ? [] : [{ level, value }]));
}

export function stripRow(strip: Strip, span: Span, numbersFrom: number): StripRow {
  const height = heights(strip);
  const bounds = boundsOf(strip);
  const line = (value: number) => `M${span.from} ${height(value).toFixed(4)}H${span.to}`;
  const unit = el('small');
  const [high, low] = [el('span', { class: 'high' }), el('span', { class: 'low' })];
  const dots = strip.curves.map(({ role }) => el('i', { class: `dot ${role}` }));
  const tag = el('b', { class: 'tag' });
  const empty = strip.curves.every(({ values }) => values.length === 0);
  const plot = el(
    'div',
    { class: 'plot' },
    stretched(
      span,
      svg('path', { class: 'bounds', d: line(strip.low) + line(strip.high) }),
      ...bounds.map(({ level, value }) => svg('path', { class: level, d: line(value) })),
      ...strip.curves.map((curve) => svg('path', { class: curve.role, d: path(curve, height) })),
    ),
    ...(empty ? [el('p', {}, 'nothing recorded')] : [...dots, tag]),
  );
  for (const [node, value] of [
    [high, strip.high],
    [low, strip.low],
  ] as const)
    node.style.top = `${height(value) * 100}%`;
  const scale = el('div', { class: 'scale' }, ...(empty ? [] : [high, low]));
  const element = el('div', { class: 'strip row' }, el('b', {}, strip.name, unit), scale, plot);
  return {
    element,
    at(position, values, word, units) {
      const { unit: name, text } = shown(strip.quantity, units);
      setText(unit, name);
      setText(high, text(strip.high));
      setText(low, text(strip.low));
      if (empty) return;
      const part = partOf(span, position);
      strip.curves.forEach((_, i) => {
        const value = values[numbersFrom + i] ?? null;
        const dot = dots[i];
        if (!dot) return;
        dot.hidden = value === null;
        if (value !== null) {
          const place = `left: ${(part * 100).toFixed(3)}%; top: ${(height(value) * 100).toFixed(2)}%`;
          setStyle(dot, place);
        }
      });
      const value = values[numbersFrom + strip.curves.length - 1] ?? null;
      const reading =
        strip.limit === null || value === null ? withUnit(strip.quantity, value, units) : text(value);
      setText(tag, `${reading} ${word}`.trim());
      for (const { level, value: bound } of bounds)
        setClass(tag, level, level !== 'limit' && value !== null && value < bound);
      placeAt(tag, part);
      const top = value === null ? 0.5 : height(value);
      tag.style.top = `clamp(${HALF_TAG}, ${(top * 100).toFixed(1)}%, 100% - ${HALF_TAG})`;
    },
  };
}

/** Lanes over the time axis. One lane marks events; the other lanes have labelled stretches of time. */

import type { Lane, Event as LogEvent, Stretch } from '../link/protocol';
import { el, setAttribute, setClass, setText, svg } from '../panel/parts/dom';
import { lengthOf, partOf, type Span } from './span';

/** A stretch shorter than this has no visible name [fraction of the axis]. */
const ROOM = 0.035;

/**
 * Gap after a stretch: a fraction of the axis, or a fraction of the stretch if that is smaller, so that short stretches
 * stay visible.
 */
const GAP = 0.0008;
const GAP_OF_STRETCH = 0.15;

export interface Row {
  readonly element: HTMLElement;
  /** Draws the playhead at the time `position` [s]. */
  at(position: number): void;
}

/** Makes an SVG that fills its element. Its x is time [s], and its y is 0 at the top and 1 at the bottom. */
export function stretched(span: Span, ...drawn: SVGElement[]): SVGElement {
  const attributes = {
    viewBox: `${span.from} 0 ${lengthOf(span)} 1`,
    preserveAspectRatio: 'none',
    'aria-hidden': 'true',
  };
  return svg('svg', attributes, ...drawn);
}

/** Returns the index of the stretch at a time. */
export function stretchAt(stretches: readonly Stretch[], position: number): number {
  let [low, high] = [0, stretches.length - 1];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((stretches[middle]?.end_s ?? 0) < position) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Returns the time at which the drawn stretch ends [s]: a gap remains before the next stretch. */
function endOf({ start_s, end_s }: Stretch, span: Span): number {
  return end_s - Math.min(GAP * lengthOf(span), GAP_OF_STRETCH * (end_s - start_s));
}

export function laneRow({ name, stretches }: Lane, span: Span): Row {
  const percent = (part: number) => `${(part * 100).toFixed(3)}%`;
  const bars = (level: string) =>
    stretches
      .filter((each) => each.label && each.level === level)
      .map((each) => `M${each.start_s} 0H${endOf(each, span)}V1H${each.start_s}Z`)
      .join('');
  const present = svg('rect', { class: 'present', y: '0', height: '1' });
  const names = stretches.map(({ start_s, end_s, label, level }) => {
    const [left, right] = [Math.max(0, partOf(span, start_s)), Math.min(1, partOf(span, end_s))];
    if (!label || right - left < ROOM) return null;
    const place = `left: ${percent(left)}; width: ${percent(right - left)}`;
    return el('span', { class: level, style: place, title: label }, label);
  });
  const now = el('b', { class: 'now' });
  const plot = el(
    'div',
    { class: 'plot' },
    stretched(
      span,
      ...['info', 'caution', 'warning'].map((level) => svg('path', { class: level, d: bars(level) })),
      present,
    ),
    ...names.filter((label) => label !== null),
    now,
  );
  let shown = -1;
  return {
    element: el('div', { class: 'lane row' }, el('b', {}, name), plot),
    at(position) {
      const index = stretchAt(stretches, position);
      const stretch = stretches[index];
      if (!stretch) return;
      const unnamed = stretch.label !== '' && names[index] === null;
      setText(now, unnamed ? stretch.label : '');
      if (unnamed) placeAt(now, partOf(span, position));
      if (index === shown) return;
      names[shown]?.classList.remove('here');
      names[index]?.classList.add('here');
      shown = index;
      setAttribute(present, 'x', String(stretch.start_s));
      setAttribute(present, 'width', String(endOf(stretch, span) - stretch.start_s));
      setClass(present, 'off', stretch.label === '' || stretch.level !== 'info');
    },
  };
}

/** Names on the time axis, by the kind of the log line. */
const NAMED: Readonly<Record<string, string>> = {
  acquired: 'captured',
  released: 'released',
  docked: 'docked',
  latched: 'latched',
};
const UNDONE = 'released';

export interface Mark {
  readonly time_s: number;
  readonly name: string;
  readonly text: string;
}

/** Returns the marks of capture, release, docking and latching. Two equal log lines of a step are one mark. */
export function marksOf(events: readonly LogEvent[]): readonly Mark[] {
  const marks: Mark[] = [];
  for (const { kind, time_s, text } of events) {
    const name = NAMED[kind];
    const last = marks.at(-1);
    if (!name || (last?.name === name && last.time_s === time_s)) continue;
    marks.push({ time_s, name, text });
  }
  return marks;
}

function markTags(events: readonly LogEvent[], span: Span): readonly HTMLElement[] {
  return marksOf(events).flatMap(({ time_s, name, text }) => {
    const part = partOf(span, time_s);
    if (part < 0 || part > 1) return [];
    const kind = [...(name === UNDONE ? ['undone'] : []), ...(part > 0.8 ? ['before'] : [])].join(' ');
    return [el('b', { class: kind, style: `left: ${(part * 100).toFixed(3)}%`, title: text }, name)];
  });
}

export function eventRow(events: readonly LogEvent[], span: Span): Row {
  const ticks = (level: string) =>
    events
      .filter((event) => event.level === level)
      .map(({ time_s }) => `M${time_s} .15V.85`)
      .join('');
  const plot = el(
    'div',
    { class: 'plot marks' },
    stretched(
      span,
      ...['info', 'caution', 'warning'].map((level) => svg('path', { class: level, d: ticks(level) })),
    ),
    ...markTags(events, span),
  );
  return { element: el('div', { class: 'lane events-lane row' }, el('b', {}, 'Events'), plot), at() {} };
}

/** Places a tag beside the playhead, on the side with enough room. */
export function placeAt(tag: HTMLElement, part: number): void {
  setClass(tag, 'before', part > 0.8);
  const percent = `${(part * 100).toFixed(3)}%`;
  if (tag.style.left !== percent) tag.style.left = percent;
}

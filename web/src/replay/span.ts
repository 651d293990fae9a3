/** The part of the run that the time axis shows. */

export interface Span {
  /** Simulated times [s]. */
  readonly from: number;
  readonly to: number;
}

/** The axis shows no less [s]: a second is then wide enough to tell frames apart. */
export const LEAST_S = 2;
/** One step in or out makes the span so many times shorter or longer. */
export const STEP = 2;
/** Position of the playhead in a span that moved with it, from the end that it came from. */
const AHEAD = 0.1;

export function lengthOf({ from, to }: Span): number {
  return to - from;
}

/** Where a time lies: 0 at the span's beginning, 1 at its end. */
export function partOf(span: Span, time: number): number {
  return (time - span.from) / lengthOf(span);
}

/** So many times shorter, the playhead in its place; never shorter than `LEAST_S`, never longer than the run. */
export function zoomed(span: Span, by: number, position: number, duration: number): Span {
  const length = Math.min(Math.max(lengthOf(span) / by, LEAST_S), duration);
  return within(position - partOf(span, position) * length, length, duration);
}

/** The span itself while the playhead is in it, else one of the same length that has it. */
export function following(span: Span, position: number, duration: number): Span {
  if (position >= span.from && position <= span.to) return span;
  const length = lengthOf(span);
  const before = position > span.to ? AHEAD : 1 - AHEAD;
  return within(position - before * length, length, duration);
}

function within(from: number, length: number, duration: number): Span {
  const begin = Math.min(Math.max(from, 0), duration - length);
  return { from: begin, to: begin + length };
}

/** The part of the run that the time axis shows. */

export interface Span {
  /** Simulated times [s]. */
  readonly from: number;
  readonly to: number;
}

/** Shortest span of the axis, at which single frames can be distinguished [s]. */
export const LEAST_S = 2;
/** Factor by which one step of zoom changes the length of the span. */
export const STEP = 2;
/**
 * The span moves when the playhead leaves it. This is then the distance of the playhead from the nearer end of the new
 * span, as a fraction of the length of the span.
 */
const AHEAD = 0.1;

export function lengthOf({ from, to }: Span): number {
  return to - from;
}

/** Returns the position of a time: 0 at the start of the span, 1 at its end. */
export function partOf(span: Span, time: number): number {
  return (time - span.from) / lengthOf(span);
}

/**
 * Returns the span, shortened by a factor around the playhead. The new length is at least `LEAST_S`, but at most the
 * length of the run.
 */
export function zoomed(span: Span, by: number, position: number, duration: number): Span {
  const length = Math.min(Math.max(lengthOf(span) / by, LEAST_S), duration);
  return within(position - partOf(span, position) * length, length, duration);
}

/** Returns the span if it contains the playhead, or else a span of the same length that contains the playhead. */
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

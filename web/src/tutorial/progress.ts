/** Progress in the tutorial, as plain data; each frame updates it. */

import type { Frame, Vec3 } from '../link/protocol';
import { held, isFree, STEPS } from './steps';

export interface Progress {
  /** Index of the present step; equal to the number of steps when all are complete. */
  readonly at: number;
  /** Position of the tip at the start of this step; null if not known yet. */
  readonly from: Vec3 | null;
  readonly looked: boolean;
  /**
   * Whether the user went back to this step. If the step's condition holds already, the step ends only after the
   * condition has become false and then true again.
   */
  readonly again: boolean;
  /** Steps that were skipped and that were not completed later. */
  readonly skipped: ReadonlySet<number>;
  /**
   * Height of the payload when it was last in its berth [m]. If it was never there, height in the first frame. Null
   * before the first frame.
   */
  readonly seat: number | null;
  /** Time at which all steps were complete and the payload was free [s]; null before this time. */
  readonly flown: number | null;
  /** Number of the last frame's control step. */
  readonly tick: number;
}

export const BEGIN: Progress = {
  at: 0,
  from: null,
  looked: false,
  again: false,
  skipped: new Set(),
  seat: null,
  flown: null,
  tick: -1,
};
const LIFT = STEPS.length - 1;

export function isOver({ at }: Progress): boolean {
  return at >= STEPS.length;
}

/**
 * Returns the progress after the next frame; `height`: the payload's height [m]. If the run was restarted, the tutorial
 * begins again.
 */
export function seen(before: Progress, now: Frame, height: number): Progress {
  if (now.tick < before.tick) return seen(BEGIN, now, height);
  const first = before.tick < 0 && held(now);
  const seated = now.work.cargo.some(({ seat }) => seat !== '');
  const from = before.from ?? now.display.actual.position;
  const seat = before.seat === null || seated ? height : before.seat;
  const at = first ? LIFT : before.at;
  const after = { ...before, at, from, seat, tick: now.tick };
  const done = STEPS[at]?.done(now, { from, looked: before.looked, lifted: height - seat }) ?? false;
  if (!done) return ended({ ...after, again: false }, now);
  if (before.again) return after;
  const skipped = new Set([...before.skipped].filter((step) => step !== at));
  return ended({ ...enter(after, at + 1), skipped }, now);
}

/** Returns the progress after the operator has changed a picture or selected another one. */
export function looked(before: Progress): Progress {
  return { ...before, looked: true, again: false };
}

export function skip(before: Progress): Progress {
  if (isOver(before)) return before;
  return { ...enter(before, before.at + 1), skipped: new Set([...before.skipped, before.at]) };
}

export function back(before: Progress): Progress {
  return { ...enter(before, Math.max(0, before.at - 1)), again: true };
}

/** Returns the progress with its final time, if all steps are complete and the payload is free. */
function ended(progress: Progress, now: Frame): Progress {
  const { flown } = progress;
  return flown === null && isOver(progress) && isFree(now) ? { ...progress, flown: now.time_s } : progress;
}

function enter(before: Progress, at: number): Progress {
  return { ...before, at, from: null, looked: false, again: false, flown: null };
}

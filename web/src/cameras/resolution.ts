/**
 * Resolution of moving pictures, chosen from the times that they took. It is as high as 25 pictures a second and
 * 100 ms from a key to its picture allow, and at least half of the screen's.
 */

/** Resolutions, as shares of the screen's in each direction. */
export const SCALES = [0.5, 0.6, 0.7, 0.8, 0.9, 1] as const;
/**
 * Greatest time from turn to turn [ms]; a turn draws all pictures once. A little less than for 25 turns a second: a key
 * waits for up to two turns and a step of the station, and its picture has to be there after 100 ms.
 */
export const SLOW_MS = 38;
/** A higher resolution is chosen only if its turns are expected to follow each other in this time [ms]. */
export const GOAL_MS = 34;
/** Number of turns of which the median counts: a few late ones change nothing. */
export const TURNS = 9;
/** Longest drawing of a still picture's pieces [ms]: a moving picture waits for it. */
const PIECE_MS = 20;
/** Speed before the first turn, assumed [CSS px in the screen's resolution per ms]. */
const UNKNOWN = 5000;
/** Least time between a change and a higher resolution [ms]. It doubles, up to the greatest, when that was too high. */
const [FIRST_MS, LONGEST_MS] = [1000, 60_000];

/** Times of a turn. */
export interface Turn {
  /** Time since the end of the turn before [ms]. */
  readonly period: number;
  /** Time of the drawing alone [ms]; the page needs the rest. */
  readonly drawing: number;
  /** Area of its pictures on the page [CSS px]. */
  readonly area: number;
}

export class Resolution {
  /** Area of still pictures that is drawn in `PIECE_MS` [CSS px]. */
  most = PIECE_MS * UNKNOWN;
  private index = 2;
  private turns: Turn[] = [];
  private changedAt = Number.NEGATIVE_INFINITY;
  private raised = false;
  private wait = FIRST_MS;
  /** Scale and time of drawing before the last change; null when the pixels' time has been computed from it. */
  private before: { readonly scale: number; readonly drawing: number } | null = null;
  /** Time of the pixels in the screen's resolution [ms]; until it is known, all of the drawing counts. */
  private pixels = Number.POSITIVE_INFINITY;

  /** Present resolution, as a share of the screen's. */
  get scale(): number {
    return SCALES[this.index] ?? 1;
  }

  /** Stores a turn, which ended at `now` [ms]. */
  took(turn: Turn, now: number): void {
    this.turns.push(turn);
    if (this.turns.length < TURNS) return;
    const drawing = this.median(({ drawing: ms }) => ms);
    const period = this.median(({ period: ms }) => ms);
    this.most = (PIECE_MS * turn.area * this.scale ** 2) / Math.max(drawing, 1);
    this.turns.shift();
    const pixels = Math.min(this.learn(drawing), drawing / this.scale ** 2);
    const expected = (index: number) => {
      const scale = SCALES[index];
      return scale === undefined
        ? Number.POSITIVE_INFINITY
        : period + pixels * (scale ** 2 - this.scale ** 2);
    };
    if (period > SLOW_MS && this.index > 0) {
      const recent = this.raised && now - this.changedAt < LONGEST_MS;
      this.wait = recent ? Math.min(2 * this.wait, LONGEST_MS) : FIRST_MS;
      let index = this.index - 1;
      while (index > 0 && expected(index) > SLOW_MS) index -= 1;
      this.change(index, drawing, now);
    } else if (now - this.changedAt >= this.wait && expected(this.index + 1) <= GOAL_MS) {
      this.change(this.index + 1, drawing, now);
    }
  }

  /** Returns the time of the pixels in the screen's resolution [ms], from the times of drawing in two resolutions. */
  private learn(drawing: number): number {
    const { before, scale } = this;
    if (before) this.pixels = Math.max(0, (drawing - before.drawing) / (scale ** 2 - before.scale ** 2));
    this.before = null;
    return this.pixels;
  }

  private change(index: number, drawing: number, now: number): void {
    this.before = { scale: this.scale, drawing };
    this.raised = index > this.index;
    this.index = index;
    this.changedAt = now;
    this.turns = [];
  }

  private median(of: (turn: Turn) => number): number {
    return this.turns.map(of).sort((a, b) => a - b)[(TURNS - 1) / 2] ?? 0;
  }
}

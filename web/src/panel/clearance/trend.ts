/** The last minute of a quantity, as a curve that grows from the right. */

/** Length of the curve, and least time between two of its points [s]. */
export const SPAN_S = 60;
const SPACING_S = 0.25;
/** Greatest step of time [s]. A longer step is a jump, caused by a restart or by a replay's playhead. */
const LEAP_S = 5;

interface Sample {
  readonly time: number;
  readonly value: number | null;
}

export class Trend {
  private samples: Sample[] = [];

  /** Adds the value at `time` [s]; null if there is none. */
  add(time: number, value: number | null): void {
    const last = this.samples.at(-1);
    if (last && (time < last.time || time - last.time > LEAP_S)) this.samples = [];
    else if (last && time - last.time < SPACING_S) return;
    this.samples.push({ time, value });
    this.samples = this.samples.filter((sample) => time - sample.time <= SPAN_S);
  }

  /** Greatest value of the last minute. */
  get greatest(): number {
    return Math.max(0, ...this.samples.map(({ value }) => value ?? 0));
  }

  /** Returns an SVG path in a unit square: `now` is at the right edge, the value `top` at the upper edge. */
  path(now: number, top: number): string {
    let pen = 'M';
    let text = '';
    for (const { time, value } of this.samples) {
      if (value === null) {
        pen = 'M';
        continue;
      }
      const height = Math.min(1, Math.max(0, value / top));
      text += `${pen}${(1 - (now - time) / SPAN_S).toFixed(4)} ${(1 - height).toFixed(4)}`;
      pen = 'L';
    }
    return text;
  }
}

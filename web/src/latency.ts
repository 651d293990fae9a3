/** Stick to picture: from an input event to the end of drawing the first frame that has flown it. */

const WINDOW_MS = 10_000;

interface Sample {
  readonly drawn: number;
  readonly ms: number;
}

export class Latency {
  private waiting: { seq: number; at: number }[] = [];
  private samples: Sample[] = [];

  /** A sticks message went out, caused by an input event at `at` [ms, as performance.now()]. */
  sent(seq: number, at: number): void {
    this.waiting.push({ seq, at });
  }

  /** A frame that has flown `stickSeq` is drawn at `now` [ms]. */
  drawn(stickSeq: number, now: number): void {
    for (const { seq, at } of this.waiting) {
      if (seq <= stickSeq) this.samples.push({ drawn: now, ms: now - at });
    }
    this.waiting = this.waiting.filter(({ seq }) => seq > stickSeq);
  }

  /** What was on its way is lost with the connection. */
  forget(): void {
    this.waiting = [];
  }

  /** 95th percentile of the last 10 s [ms], or null where no stick moved. */
  percentile95(now: number): number | null {
    this.samples = this.samples.filter(({ drawn }) => now - drawn <= WINDOW_MS);
    const sorted = this.samples.map(({ ms }) => ms).sort((a, b) => a - b);
    return sorted[Math.ceil(0.95 * sorted.length) - 1] ?? null;
  }
}

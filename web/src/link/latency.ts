/**
 * Stick to picture: from an input event until the first frame that has taken it is drawn on the page. And the command's
 * way: until the frame is here that has flown it, after the delay that a scenario may set.
 */

import { Samples } from './samples';

/** A station that is well answers within this time, a control period and the way there and back [ms]. */
const ANSWERED_MS = 40;
/** Pictures wait for an input so seldom [ms]. */
const HELD_MS = 150;

export class Latency {
  private waiting: { seq: number; at: number }[] = [];
  private readonly samples = new Samples();
  private unanswered: { seq: number; at: number }[] = [];
  private readonly answers = new Samples();
  /** The input that pictures waited for last. */
  private heldFor = Number.NEGATIVE_INFINITY;

  /** `cameraDelay`: pictures are late by this much, which is not counted [s]. */
  constructor(private readonly cameraDelay = 0) {}

  /** A sticks message went out, caused by an input event at `at` [ms, as performance.now()]. */
  sent(seq: number, at: number): void {
    this.waiting.push({ seq, at });
    this.unanswered.push({ seq, at });
  }

  /** A frame that has taken `stickSeq` is drawn at `now` [ms]. */
  drawn(stickSeq: number, now: number): void {
    for (const { seq, at } of this.waiting) {
      if (seq <= stickSeq) this.samples.add(now - at - 1000 * this.cameraDelay, now);
    }
    this.waiting = this.waiting.filter(({ seq }) => seq > stickSeq);
  }

  /** A frame that has flown `flownSeq` has come at `now` [ms]. */
  answered(flownSeq: number, now: number): void {
    for (const { seq, at } of this.unanswered) {
      if (seq <= flownSeq) this.answers.add(now - at, now);
    }
    this.unanswered = this.unanswered.filter(({ seq }) => seq > flownSeq);
  }

  /** What the inputs of the last 10 s took to their frame, the middle of them [s]; null where no stick moved. */
  answer(now: number): number | null {
    const ms = this.answers.part(0.5, now);
    return ms === null ? null : ms / 1000;
  }

  /**
   * Whether the frame that has flown an input is about to arrive: a picture of `stickSeq`, begun now, would hold it up.
   * Where inputs never end, not each of them is waited for.
   */
  due(stickSeq: number, now: number): boolean {
    if (this.cameraDelay > 0) return false;
    const input = this.waiting.find(({ seq, at }) => seq > stickSeq && now - at < ANSWERED_MS);
    if (!input || (input.at > this.heldFor && input.at < this.heldFor + HELD_MS)) return false;
    this.heldFor = input.at;
    return true;
  }

  /** What was on its way is lost with the connection. */
  forget(): void {
    this.waiting = [];
    this.unanswered = [];
  }

  /** 95th percentile of the last 10 s [ms], or null where no stick moved. */
  percentile95(now: number): number | null {
    return this.samples.part(0.95, now);
  }
}

/**
 * Two latencies of an input event. The first one ends with the picture of the first frame that the station sent after
 * it received the input. The second one ends when the first frame arrives that used the input, so it includes the
 * scenario's command delay.
 */

import { Samples } from './samples';

/** Normal time from an input to its frame: a control period and the transmission [ms]. */
const ANSWERED_MS = 40;
/** Least time between two inputs that each delay a picture [ms]. */
const HELD_MS = 150;

export class Latency {
  private waiting: { seq: number; at: number }[] = [];
  private readonly samples = new Samples();
  private unanswered: { seq: number; at: number }[] = [];
  private readonly answers = new Samples();
  /** Time of the last input that delayed a picture [ms]. The picture waits for a frame with this input. */
  private heldFor = Number.NEGATIVE_INFINITY;

  /** Records a sticks message that was sent because of an input event at `at` [ms, as performance.now()]. */
  sent(seq: number, at: number): void {
    this.waiting.push({ seq, at });
    this.unanswered.push({ seq, at });
  }

  /**
   * Records that a picture was drawn at `now` [ms]. `stickSeq`: number of the last sticks message that the station
   * received before the picture's frame; `late`: the link's delay of the picture, which is not counted [s].
   */
  drawn(stickSeq: number, now: number, late = 0): void {
    for (const { seq, at } of this.waiting) {
      if (seq <= stickSeq) this.samples.add(now - at - 1000 * late, now);
    }
    this.waiting = this.waiting.filter(({ seq }) => seq > stickSeq);
  }

  /** Records that a frame arrived at `now` [ms]; `flownSeq`: `seq` of the sticks message that the frame used. */
  answered(flownSeq: number, now: number): void {
    for (const { seq, at } of this.unanswered) {
      if (seq <= flownSeq) this.answers.add(now - at, now);
    }
    this.unanswered = this.unanswered.filter(({ seq }) => seq > flownSeq);
  }

  /** Median time from an input to the frame that used it, in the last 10 s [s]; null if no stick moved. */
  answer(now: number): number | null {
    const ms = this.answers.part(0.5, now);
    return ms === null ? null : ms / 1000;
  }

  /**
   * Whether the next picture without delay should wait, because a frame with a newer input than `stickSeq` will arrive soon. A
   * picture that is started now would delay that frame's picture. While inputs arrive continuously, pictures are
   * delayed for at most one input in each period of `HELD_MS`.
   */
  due(stickSeq: number, now: number): boolean {
    const input = this.waiting.find(({ seq, at }) => seq > stickSeq && now - at < ANSWERED_MS);
    if (!input || (input.at > this.heldFor && input.at < this.heldFor + HELD_MS)) return false;
    this.heldFor = input.at;
    return true;
  }

  /** Discards the inputs that still wait for a frame. Called when no frame will contain them. */
  forget(): void {
    this.waiting = [];
    this.unanswered = [];
  }

  /** 95th percentile of the latency to pictures in the last 10 s [ms]; null if no stick moved. */
  percentile95(now: number): number | null {
    return this.samples.part(0.95, now);
  }
}

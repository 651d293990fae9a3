/** Position and speed of a playback, and the blocks of frames around the playhead; independent of the page. */

import type { Block, Moment, PlaybackIndex } from '../link/protocol';

export const SPEEDS = [0.25, 0.5, 1, 2, 4, 8] as const;
/** Greatest number of stored blocks, so that memory does not grow with the length of the recording. */
const MOST_KEPT = 8;
/** Number of blocks requested in advance if playback is faster than normal; otherwise the number is 1. */
const AHEAD = 2;
/** Time after which a failed block is requested again [ms]. */
const AGAIN_MS = 1000;
/** Tolerance for the rounding of times, as a fraction of the period. Exact times are multiples of the period. */
const ROUNDING = 1e-6;

type Extent = Pick<PlaybackIndex, 'period_s' | 'ticks' | 'stride' | 'block'>;

export class Player {
  /** Simulated time of the playhead [s]. */
  position: number;
  speed = 1;
  playing = false;
  /** Reason why frames are missing, in a sentence; empty if no frames are missing. */
  failure = '';
  private readonly blocks = new Map<number, Block>();
  private readonly waiting = new Set<number>();

  constructor(
    private readonly extent: Extent,
    private readonly load: (number: number) => Promise<Block>,
  ) {
    this.position = this.start;
    this.fetch();
  }

  /** Time of the first and of the last frame [s]. */
  get start(): number {
    return this.extent.period_s;
  }

  get duration(): number {
    return this.extent.period_s * this.extent.ticks;
  }

  /** Index of the last recorded frame at or before the playhead. */
  get number(): number {
    const tick = Math.floor(this.position / this.extent.period_s + ROUNDING);
    return Math.floor((Math.min(Math.max(tick, 1), this.extent.ticks) - 1) / this.extent.stride);
  }

  /** Frame and values at the playhead; null until they are loaded. */
  get moment(): Moment | null {
    const { block } = this.extent;
    return this.blocks.get(Math.floor(this.number / block))?.[this.number % block] ?? null;
  }

  /** Starts to play. If the playhead is at the end, it moves to the start first. */
  play(): void {
    if (this.position >= this.duration) this.seek(this.start);
    this.playing = true;
  }

  pause(): void {
    this.playing = false;
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  /** Moves the playhead to a time [s], limited to the recording. */
  seek(position: number): void {
    this.position = Math.min(Math.max(position, this.start), this.duration);
    this.fetch();
  }

  /** Pauses, and moves the playhead by a number of frames, forwards or back. */
  step(frames: number): void {
    const { period_s, stride } = this.extent;
    this.pause();
    this.seek(period_s * (1 + (this.number + frames) * stride));
  }

  faster(): void {
    this.speed = SPEEDS.find((speed) => speed > this.speed) ?? this.speed;
  }

  slower(): void {
    this.speed = SPEEDS.findLast((speed) => speed < this.speed) ?? this.speed;
  }

  /** Advances the playhead by `dt` [s of the clock] times the speed, or waits if the frame there is not loaded. */
  advance(dt: number): void {
    if (this.playing && this.moment) {
      this.seek(this.position + dt * this.speed);
      if (this.position >= this.duration) this.pause();
    } else {
      this.fetch();
    }
  }

  /** Requests the block at the playhead and the next blocks; deletes the blocks that were unused for longest. */
  private fetch(): void {
    const { block, ticks, stride } = this.extent;
    const last = Math.floor((Math.ceil(ticks / stride) - 1) / block);
    const here = Math.floor(this.number / block);
    const ahead = this.speed > 1 ? AHEAD : 1;
    for (let number = Math.min(here + ahead, last); number >= here; number -= 1) this.want(number);
    for (const [number] of this.blocks) {
      if (this.blocks.size <= MOST_KEPT) break;
      this.blocks.delete(number);
    }
  }

  private want(number: number): void {
    const kept = this.blocks.get(number);
    if (kept) {
      this.blocks.delete(number);
      this.blocks.set(number, kept);
      return;
    }
    if (this.waiting.has(number)) return;
    this.waiting.add(number);
    this.load(number).then(
      (block) => {
        this.blocks.set(number, block);
        this.waiting.delete(number);
        this.failure = '';
      },
      () => {
        this.failure = 'The recording does not answer; is `aftdeck replay` still running?';
        setTimeout(() => this.waiting.delete(number), AGAIN_MS);
      },
    );
  }
}

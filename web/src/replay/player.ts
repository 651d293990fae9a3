/** A recording's position, speed and the blocks of frames round it; it knows nothing of the page. */

import type { Block, Moment, PlaybackIndex } from '../link/protocol';

export const SPEEDS = [0.25, 0.5, 1, 2, 4, 8] as const;
/** Blocks kept decoded, so that memory does not grow with the recording. */
const MOST_KEPT = 8;
/** Playing fast, this many blocks are fetched ahead. */
const AHEAD = 2;
/** A block that did not come is asked for again after this time [ms]. */
const AGAIN_MS = 1000;
/** Times are multiples of the period; this much of one is rounding [periods]. */
const ROUNDING = 1e-6;

type Extent = Pick<PlaybackIndex, 'period_s' | 'ticks' | 'stride' | 'block'>;

export class Player {
  /** Simulated time of the playhead [s]. */
  position: number;
  speed = 1;
  playing = false;
  /** Why frames do not come, in a sentence; empty while they do. */
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

  /** Number of the frame at the playhead: the last one drawn that is not ahead of it. */
  get number(): number {
    const tick = Math.floor(this.position / this.extent.period_s + ROUNDING);
    return Math.floor((Math.min(Math.max(tick, 1), this.extent.ticks) - 1) / this.extent.stride);
  }

  /** The moment at the playhead; null until it has come. */
  get moment(): Moment | null {
    const { block } = this.extent;
    return this.blocks.get(Math.floor(this.number / block))?.[this.number % block] ?? null;
  }

  /** Plays on, from the beginning where the end was reached. */
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

  /** Puts the playhead at a time [s], within the recording. */
  seek(position: number): void {
    this.position = Math.min(Math.max(position, this.start), this.duration);
    this.fetch();
  }

  /** Step forwards or back by frames, and pause. */
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

  /** Time went on by `dt` [s of the clock]; the playhead waits for frames that have not come. */
  advance(dt: number): void {
    if (this.playing && this.moment) {
      this.seek(this.position + dt * this.speed);
      if (this.position >= this.duration) this.pause();
    } else {
      this.fetch();
    }
  }

  /** Asks for the block at the playhead and those after it, and drops those longest unused. */
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

/** The frames that a page shows now or later: the newest one names those that it shows now. */

import { PictureFrames } from './picture-frames';
import type { Frame, LinkSteps } from './protocol';

/** `telemetry`: numbers, lamps, tones and log; `camera`: pictures. */
export type Shows = 'telemetry' | 'camera';

export interface Seen {
  readonly frame: Frame;
  /** Number of the frame's step. */
  readonly step: number;
  /** Number of restarts before this frame. Restarts are counted when frames arrive, so that none is missed. */
  readonly restarts: number;
}

/** Returns the number of a frame's step and the steps that pages show with it; a replay shows the frame itself. */
export function linkOf({ tick, display }: Pick<Frame, 'tick' | 'display'>): LinkSteps {
  return display.link ?? { step: tick, telemetry: tick, pictures: tick, cameras: [] };
}

export class Frames {
  /** In the order of their steps; the newest one is the last. */
  private readonly kept: Seen[] = [];
  private named: Readonly<Record<Shows, number>> = { telemetry: 0, camera: 0 };
  /** Named steps of the cameras that show another step. */
  private own: ReadonlyMap<string, number> = new Map();
  private arrivedAt = 0;

  /** `period`: control period [s]. */
  constructor(private readonly period: number) {}

  /** The newest frame; null before the first one. */
  get newest(): Seen | null {
    return this.kept.at(-1) ?? null;
  }

  /** Adds a frame that arrived at `now` [ms], and drops those that are not shown any more; returns whether it begins a run. */
  put(frame: Frame, now: number): boolean {
    const { kept, newest: before } = this;
    const { step, telemetry, pictures, cameras } = linkOf(frame);
    const back = before !== null && step < before.step; // in another session, or in a recording
    const begins = back || (before !== null && step - frame.tick !== before.step - before.frame.tick);
    if (back) kept.length = 0;
    if (step === before?.step) kept.pop();
    kept.push({ frame, step, restarts: (before?.restarts ?? 0) + Number(begins) });
    this.named = { telemetry, camera: pictures };
    this.own = new Map(cameras);
    this.arrivedAt = now;
    const earliest = Math.min(telemetry, pictures, ...this.own.values());
    const first = kept.findLastIndex((seen) => seen.step <= earliest);
    kept.splice(0, Math.max(0, first));
    return begins;
  }

  /** The frame to show: the newest one up to the named step, or else the oldest one; null before the first one. */
  at(shows: Shows, camera = ''): Seen | null {
    const named = this.step(shows, camera);
    return this.kept.findLast(({ step }) => step <= named) ?? this.kept[0] ?? null;
  }

  /** The frames to show in pictures; null before the first one. */
  get pictures(): PictureFrames | null {
    const seen = this.at('camera');
    if (!seen || this.own.size === 0) return seen && new PictureFrames(seen.frame);
    const own = [...this.own.keys()].map((name) => [name, (this.at('camera', name) ?? seen).frame] as const);
    return new PictureFrames(seen.frame, new Map(own));
  }

  /** Whether the link has let a frame through. The first frames are shown before. */
  isThrough(shows: Shows, { step }: Seen): boolean {
    return step <= this.named[shows];
  }

  /** Time from the step of a frame to the step of the newest one [s]. */
  behind({ step }: Seen): number {
    return this.period * ((this.newest?.step ?? step) - step);
  }

  /** Time from the arrival of the newest frame to `now` [ms], in seconds; 0 before the first one. */
  silence(now: number): number {
    return this.newest ? Math.max(0, now - this.arrivedAt) / 1000 : 0;
  }

  /** The part of the shown frame's age that is the link's [s]. */
  late(shows: Shows, camera = ''): number {
    const [newest, shown] = [this.newest, this.at(shows, camera)];
    return newest && shown ? this.period * (newest.step - Math.max(this.step(shows, camera), shown.step)) : 0;
  }

  /** The named step; of a camera only in pictures. */
  private step(shows: Shows, camera: string): number {
    return (shows === 'camera' ? this.own.get(camera) : undefined) ?? this.named[shows];
  }
}

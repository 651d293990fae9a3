/** Stores frames and log lines until the scenario's delays are over, and measures the actual delays. */

import type { Delays } from '../panel/rail/delays';
import { type Age, DelayLine, type Seen } from './delay-line';
import type { Frame, Event as LogEvent, Welcome } from './protocol';
import { Samples } from './samples';

/** `telemetry`: numbers, lamps, tones and log; `camera`: pictures. */
export type Shows = 'telemetry' | 'camera';

interface Line {
  readonly line: DelayLine;
  /** Age of each frame when it was displayed for the first time [s]. */
  readonly ages: Samples;
  last: Seen | null;
}

export class Arrivals {
  /** Number of restarts of the run. */
  restarts = 0;
  /** Whether the run stands still, so that no frame is missing. */
  stands = false;
  private newest: Seen | null = null;
  private readonly lines: Readonly<Record<Shows, Line>>;
  /** Lines of the log that are not due yet. */
  private log: LogEvent[] = [];
  private readonly command: number;

  constructor(welcome: Pick<Welcome, 'command_delay_s' | 'telemetry_delay_s' | 'camera_delay_s'>) {
    const line = (delay: number) => ({ line: new DelayLine(delay), ages: new Samples(), last: null });
    this.command = welcome.command_delay_s;
    this.lines = { telemetry: line(welcome.telemetry_delay_s), camera: line(welcome.camera_delay_s) };
  }

  /** Adds a frame that arrived at `now` [ms]; returns whether it is the first frame after a restart. */
  put(frame: Frame, now: number): boolean {
    const anew = this.newest !== null && frame.tick < this.newest.frame.tick;
    if (anew) this.restarts += 1;
    this.newest = { frame, at: now };
    for (const { line } of Object.values(this.lines)) line.put(this.newest);
    return anew;
  }

  /** The frame to display at `now` [ms]; null before the first one. */
  at(shows: Shows, now: number): Seen | null {
    return this.lines[shows].line.at(now);
  }

  /** The frame now displayed by the numbers, the lamps and the log; null before the first frame. */
  get telemetry(): Frame | null {
    return this.at('telemetry', performance.now())?.frame ?? null;
  }

  age(shows: Shows, now: number): Age {
    return this.lines[shows].line.age(now, this.stands);
  }

  /** Time since the last frame [s]. */
  silence(now: number): number {
    return this.stands ? 0 : (now - (this.newest?.at ?? now)) / 1000;
  }

  /** Records that a frame is displayed at `now` [ms]. A frame displayed before its delay is over does not count. */
  show(shows: Shows, seen: Seen, now: number): void {
    const line = this.lines[shows];
    const age = (now - seen.at) / 1000;
    if (line.last !== seen && age >= line.line.delay) line.ages.add(age, now);
    line.last = seen;
    line.line.displayed(now);
  }

  /** Called at `now` [ms] while nobody can see the page: what it does not draw meanwhile does not count as old. */
  unseen(now: number): void {
    for (const { line } of Object.values(this.lines)) line.displayed(now);
  }

  /** Returns the delays as set and as measured; `answer`: time from an input to the frame that used it [s]. */
  delays(answer: number | null, now: number): Delays {
    const { telemetry, camera } = this.lines;
    const shown = ({ line, ages }: Line) => ({ set: line.delay, measured: ages.part(0.5, now) });
    return {
      command: { set: this.command, measured: answer },
      telemetry: shown(telemetry),
      camera: shown(camera),
    };
  }

  /** Adds log lines. A line is due when the displayed frame reaches the line's time; without a delay, at once. */
  addEvents(events: readonly LogEvent[]): void {
    this.log.push(...events);
  }

  /** Removes and returns the lines that are due at `now` [ms]. */
  dueEvents(now: number): readonly LogEvent[] {
    const { line } = this.lines.telemetry;
    const until = line.delay > 0 ? (line.at(now)?.frame.time_s ?? 0) : Infinity;
    const later = this.log.findIndex(({ time_s }) => time_s > until);
    return this.log.splice(0, later < 0 ? Infinity : later);
  }

  /** Removes and returns all lines that are not due yet. */
  takeEvents(): readonly LogEvent[] {
    return this.log.splice(0);
  }
}

/** The frames that the operator's page has received, and the delays with which it shows them, as set and as measured. */

import type { Delays } from '../panel/rail/delays';
import { type Age, Displayed } from './age';
import { Frames, type Seen, type Shows } from './frames';
import type { PictureFrames } from './picture-frames';
import type { Frame, Welcome } from './protocol';
import { Samples } from './samples';

/** Delays that the scenario sets; changes in flight change them here. */
type LinkDelays = Pick<
  Welcome,
  'control_period_s' | 'command_delay_s' | 'telemetry_delay_s' | 'camera_delay_s'
>;

interface Measured {
  readonly displayed: Displayed;
  /** Age of each frame when it was displayed for the first time [s]. */
  readonly ages: Samples;
  last: Seen | null;
}

export class Arrivals {
  /** Whether the run stands still, so that no frame is missing. */
  stands = false;
  private readonly frames: Frames;
  private readonly shown: Readonly<Record<Shows, Measured>>;

  constructor(private readonly welcome: LinkDelays) {
    const frames = new Frames(welcome.control_period_s);
    const measured = (shows: Shows) => ({
      displayed: new Displayed(frames, shows),
      ages: new Samples(),
      last: null,
    });
    this.frames = frames;
    this.shown = { telemetry: measured('telemetry'), camera: measured('camera') };
  }

  /** Adds a frame that arrived at `now` [ms]; returns whether it is the first frame after a restart. */
  put(frame: Frame, now: number): boolean {
    return this.frames.put(frame, now);
  }

  /** The frame to display; null before the first one. */
  at(shows: Shows): Seen | null {
    return this.frames.at(shows);
  }

  /** The frame now displayed by the numbers and the lamps; null before the first frame. */
  get telemetry(): Frame | null {
    return this.at('telemetry')?.frame ?? null;
  }

  /** The part of the age of the displayed frame that is the link's [s]. */
  late(shows: Shows): number {
    return this.frames.late(shows);
  }

  /** The frames to show in pictures; null before the first one. */
  get pictures(): PictureFrames | null {
    return this.frames.pictures;
  }

  age(shows: Shows, now: number, camera = ''): Age {
    return this.shown[shows].displayed.age(now, this.stands, camera);
  }

  /** Time since the last frame [s]. */
  silence(now: number): number {
    return this.stands ? 0 : this.frames.silence(now);
  }

  /** Records that a frame is displayed at `now` [ms]. A frame displayed before its delay is over does not count. */
  show(shows: Shows, seen: Seen, now: number): void {
    const shown = this.shown[shows];
    if (shown.last?.step !== seen.step && this.frames.isThrough(shows, seen))
      shown.ages.add(this.frames.behind(seen) + this.frames.silence(now), now);
    shown.last = seen;
    shown.displayed.displayed(now);
  }

  /** Called at `now` [ms] while nobody can see the page: what it does not draw meanwhile does not count as old. */
  unseen(now: number): void {
    for (const { displayed } of Object.values(this.shown)) displayed.displayed(now);
  }

  /** Returns the delays as set and as measured; `answer`: time from an input to the frame that used it [s]. */
  delays(answer: number | null, now: number): Delays {
    const { command_delay_s, telemetry_delay_s, camera_delay_s } = this.welcome;
    const { telemetry, camera } = this.shown;
    return {
      command: { set: command_delay_s, measured: answer },
      telemetry: { set: telemetry_delay_s, measured: telemetry.ages.part(0.5, now) },
      camera: { set: camera_delay_s, measured: camera.ages.part(0.5, now) },
    };
  }
}

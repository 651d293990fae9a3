/** Cameras on the monitors of a replay: the cameras of the run, until the user chooses one. */

import type { Monitors } from '../cameras/monitors';
import type { PlaybackIndex } from '../link/protocol';
import { AT } from './event-steps';

type Recorded = PlaybackIndex['pictures'];

export class FlownCameras {
  /** Whether the user has chosen a camera. */
  private chosen = false;
  /** Whether a change of the monitors comes from this class, not from the user. */
  private following = false;

  constructor(
    private readonly recorded: Recorded,
    private readonly monitors: Pick<Monitors, 'show'>,
  ) {}

  /** Whether the monitors show the cameras of the run; null if the recording does not contain them. */
  get state(): boolean | null {
    return this.recorded.some(({ monitors }) => monitors.some((names) => names.length > 0))
      ? !this.chosen
      : null;
  }

  /** Called when a monitor has changed. */
  changed(): void {
    this.chosen ||= !this.following;
  }

  /** Shows the run's cameras again. */
  reset(): void {
    this.chosen = false;
  }

  /** Shows the cameras that the run had at a position [s], unless the user has chosen others. */
  show(position: number): void {
    if (this.chosen) return;
    const flown = this.recorded.findLast(({ time_s }) => time_s <= position + AT) ?? this.recorded[0];
    this.following = true;
    flown?.monitors.forEach((names, i) => {
      if (names.length > 0) this.monitors.show(i, names);
    });
    this.following = false;
  }
}

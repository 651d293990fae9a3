/** Cameras on the monitors of a replay: those of the run, until the user chooses one. */

import type { Monitors } from '../cameras/monitors';
import type { PlaybackIndex } from '../link/protocol';
import { AT } from './event-steps';

type Recorded = PlaybackIndex['pictures'];

export class FlownCameras {
  /** The user has chosen a camera. */
  private chosen = false;
  /** This class, not the user, changes the monitors. */
  private following = false;

  constructor(
    private readonly recorded: Recorded,
    private readonly monitors: Pick<Monitors, 'show'>,
  ) {}

  /** Whether the monitors show the run's cameras; null if the recording contains none. */
  get state(): boolean | null {
    return this.recorded.some(({ monitors }) => monitors.some((names) => names.length > 0))
      ? !this.chosen
      : null;
  }

  /** A monitor has changed. */
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

/** Reports of the page in control to the station: its latency, and the cameras on its monitors. */

import type { Command } from '../link/socket';

/** Time between two reports [ms]; a change of the cameras is reported at once. */
const REPORT_MS = 1000;

export class Report {
  private at = 0;
  private monitors = '';

  constructor(private readonly send: (command: Command) => void) {}

  /** Sends a report if it is due at the time `now` [ms]. */
  update(latency_ms: number | null, monitors: readonly (readonly string[])[], now: number): void {
    const shown = monitors.join('/');
    if (now - this.at < REPORT_MS && shown === this.monitors) return;
    [this.at, this.monitors] = [now, shown];
    this.send({ type: 'shown', latency_ms, monitors });
  }
}

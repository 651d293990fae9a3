/** The page's log: the page's own lines, and the station's lines, which the station sends when the page shows their step. */

import type { Arrivals } from '../link/arrivals';
import type { Level, Event as LogEvent } from '../link/protocol';
import type { EventsGroup } from '../panel/desk/events';
import type { LampName } from '../panel/spine/lamps';

/** Greatest age of a rejection that lights a lamp [s]. A page that reconnects also receives old rejections. */
const RECENT_S = 2;

/** Least time between two equal lines of `sayOnce` [ms]. */
const OFTEN_MS = 5000;

export class Log {
  /** Time of the last rejected command [ms]. */
  refusedAt = -Infinity;
  private often = { text: '', at: -Infinity };

  constructor(
    private readonly group: EventsGroup,
    private readonly arrivals: Arrivals,
  ) {}

  /** Adds lines of the station. */
  add(events: readonly LogEvent[]): void {
    if (events.length === 0) return;
    const frame = this.arrivals.telemetry;
    const recent = (frame?.time_s ?? 0) - RECENT_S;
    const refused = events.some(({ kind, time_s }) => kind === 'refused' && time_s >= recent);
    if (refused && frame) this.refusedAt = performance.now();
    this.group.add(events);
  }

  /** Adds a line that comes from the page, not from the station. */
  say(text: string, kind = 'page', level: Level = 'caution'): void {
    this.group.add([{ time_s: this.arrivals.telemetry?.time_s ?? 0, kind, level, text }]);
  }

  /** Adds a line that comes from the page, unless the page has added the same line in the last seconds. */
  sayOnce(text: string): void {
    const now = performance.now();
    if (text === this.often.text && now - this.often.at < OFTEN_MS) return;
    this.often = { text, at: now };
    this.say(text);
  }

  /** Adds the reason for a rejected command, and lights CHECK CRT. */
  refuse(text: string): void {
    this.refusedAt = performance.now();
    this.say(text);
  }

  /** Shows only the lines of these kinds; the kinds belong to `lamp`. A second call for this lamp shows all lines. */
  keepTo(lamp: LampName, kinds: readonly string[]): void {
    this.group.keepTo(lamp, kinds);
  }

  /** Writes the lines that fit into the present size of the window. */
  resized(): void {
    this.group.draw();
  }

  clear(): void {
    this.group.clear();
  }
}

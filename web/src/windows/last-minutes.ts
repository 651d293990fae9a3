/** The last minutes of a run, as data for lanes and strips. Older data is dropped. */

import type { Lane, Event as LogEvent, Recent, Sample, Strip } from '../link/protocol';
import { shown } from '../replay/quantity';
import type { Span } from '../replay/span';
import type { Timed } from '../replay/timeline';
import { roundRange } from '../words/round-range';
import type { Units } from '../words/units';

/** Length of the stored data [s]. */
export const KEPT_S = 300;

export class LastMinutes {
  private strips: readonly Strip[] = [];
  private lanes: readonly Lane[] = [];
  private samples: Sample[] = [];
  private events: LogEvent[] = [];

  take({ strips, samples, lanes }: Recent): void {
    if (strips.length > 0) {
      this.strips = strips;
      this.samples = [];
      this.lanes = [];
    }
    if (lanes.length > 0) this.lanes = lanes;
    this.samples.push(...samples);
    const before = this.now - KEPT_S;
    const kept = this.samples.findIndex(({ time_s }) => time_s >= before);
    this.samples.splice(0, kept);
    this.forgetEvents(before);
  }

  /** Adds lines to the log. If a line's time is before that of the last line, the run was restarted: clears the log. */
  note(events: readonly LogEvent[]): void {
    for (const event of events) {
      const last = this.events.at(-1);
      if (last && event.time_s < last.time_s) this.events = [];
      this.events.push(event);
    }
    this.forgetEvents((this.events.at(-1)?.time_s ?? 0) - KEPT_S);
  }

  /** Deletes the log; the station sends all lines again. */
  forget(): void {
    this.events = [];
  }

  /** The newest sample; null before the first one. */
  get newest(): Sample | null {
    return this.samples.at(-1) ?? null;
  }

  /** Time of the newest sample [s]; 0 before the first one. */
  get now(): number {
    return this.newest?.time_s ?? 0;
  }

  /** All strips of the scenario, with empty curves. */
  get blank(): readonly Strip[] {
    return this.strips;
  }

  /** Returns lanes, events and strips for a span of the time axis. Only the chosen strips have curves. */
  over(span: Span, chosen: readonly string[], units: Units): Timed {
    const begin = Math.max(
      0,
      this.samples.findIndex(({ time_s }) => time_s >= span.from),
    );
    const samples = this.samples.slice(begin);
    let first = 0;
    const strips = this.strips.map((strip) => {
      const from = first;
      first += strip.curves.length;
      return chosen.includes(strip.name) ? drawn(strip, samples, from, units) : strip;
    });
    const events = this.events.filter(({ time_s }) => time_s >= span.from);
    return { lanes: this.lanes.map((lane) => goingOn(lane, span, this.now)), events, strips };
  }

  private forgetEvents(before: number): void {
    this.events = this.events.filter(({ time_s }) => time_s >= before);
  }
}

/** Returns a lane without the stretches that ended before the span; the last stretch is extended to `now`. */
function goingOn({ name, stretches }: Lane, span: Span, now: number): Lane {
  const begun = stretches.filter(({ start_s }) => start_s <= now);
  const until = begun.map((each, i) => (i === begun.length - 1 ? { ...each, end_s: now } : each));
  return { name, stretches: until.filter(({ end_s }) => end_s >= span.from) };
}

/** Returns a strip with curves from the samples; `first`: index of the strip's first curve in a sample's values. */
function drawn(strip: Strip, samples: readonly Sample[], first: number, units: Units): Strip {
  const times_s = samples.map(({ time_s }) => time_s);
  let [low, high] = strip.rests ? [0, strip.caution ?? 0] : [Infinity, -Infinity];
  let some = false;
  const curves = strip.curves.map(({ role }, i) => {
    const values = samples.map((sample) => sample.values[first + i] ?? null);
    for (const value of values) {
      if (value === null) continue;
      some = true;
      if (value < low) low = value;
      if (value > high) high = value;
    }
    return { role, times_s, values };
  });
  if (!some) return strip;
  const range = roundRange(low, high, shown(strip.quantity, units).perSi);
  return { ...strip, curves, low: range[0], high: range[1] };
}

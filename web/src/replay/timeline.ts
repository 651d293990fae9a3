/** The time axis and the playhead over lanes and strips; a click or a drag moves the playhead. */

import { onPress } from '../input/press';
import type { Moment, PlaybackIndex } from '../link/protocol';
import { el, setAttribute } from '../panel/parts/dom';
import type { Units } from '../words/units';
import { labels } from './axis';
import { eventRow, laneRow, type Row } from './lanes';
import { minutes } from './quantity';
import { following, lengthOf, partOf, type Span, zoomed } from './span';
import { type StripRow, stripRow } from './strips';

/** The strip whose value is followed by the name of a joint. */
const NAMES_JOINT = 'Joint rate';

/** Lanes and strips over the time axis. */
export type Timed = Pick<PlaybackIndex, 'lanes' | 'events' | 'strips'>;

export class Timeline {
  readonly element: HTMLElement;
  private lanes: readonly Row[] = [];
  private span: Span;
  private chosen: readonly string[] = [];
  private readonly axis = el('div', { class: 'plot' });
  private readonly laneRows = el('div', { class: 'lanes' });
  private readonly strips = el('div', { class: 'strips' });
  private readonly rows = new Map<string, StripRow>();
  private readonly firsts = new Map<string, number>();
  private readonly future = el('div', { class: 'future' });
  private readonly head = el('div', { class: 'playhead' });
  private readonly slider: HTMLElement;

  /** `duration`: length of the run [s]; `sought`: called when the user moves the playhead; null if the user cannot. */
  constructor(
    private index: Timed,
    private readonly duration: number,
    sought: ((position: number) => void) | null,
  ) {
    let first = 0;
    for (const { name, curves } of index.strips) {
      this.firsts.set(name, first);
      first += curves.length;
    }
    // For a live run, the duration is infinite, and `renew` sets the span before anything is visible.
    this.span = { from: 0, to: Number.isFinite(this.duration) ? this.duration : 1 };
    this.slider = el(
      'div',
      {
        class: 'scrub',
        role: 'slider',
        tabindex: '0',
        'aria-label': 'Playhead',
        'aria-valuemin': '0',
        'aria-valuemax': this.duration.toFixed(2),
      },
      this.future,
      this.head,
    );
    this.element = el(
      'div',
      { class: 'timeline' },
      el('div', { class: 'axis row' }, this.axis),
      this.laneRows,
      this.strips,
      ...(sought ? [this.slider] : []),
    );
    if (sought) this.seekBy(sought);
    this.draw();
  }

  /** Whether less than the whole run is shown. */
  get isZoomed(): boolean {
    return lengthOf(this.span) < this.duration;
  }

  /** Zooms by a factor around the playhead. */
  zoom(by: number, position: number): void {
    this.look(zoomed(this.span, by, position, this.duration));
  }

  /** Replaces data and span, and draws them. */
  renew(index: Timed, span: Span): void {
    this.index = index;
    this.span = span;
    this.draw();
  }

  /** Draws these strips, in this order. */
  choose(names: readonly string[]): void {
    this.chosen = names;
    this.drawStrips();
  }

  /** Moves the playhead; `moment` is null if the frame is not loaded. */
  show(position: number, moment: Pick<Moment, 'values' | 'worst'> | null, units: Units): void {
    this.look(following(this.span, position, this.duration));
    const percent = `${(partOf(this.span, position) * 100).toFixed(3)}%`;
    this.future.style.left = percent;
    this.head.style.left = percent;
    setAttribute(this.slider, 'aria-valuenow', position.toFixed(2));
    setAttribute(this.slider, 'aria-valuetext', minutes(position));
    for (const lane of this.lanes) lane.at(position);
    if (!moment) return;
    for (const [name, row] of this.rows)
      row.at(position, moment.values, name === NAMES_JOINT ? moment.worst : '', units);
  }

  private look(span: Span): void {
    if (span.from === this.span.from && span.to === this.span.to) return;
    this.span = span;
    this.draw();
  }

  private draw(): void {
    const { lanes, events } = this.index;
    this.axis.replaceChildren(...labels(this.span));
    this.lanes = [...lanes.map((lane) => laneRow(lane, this.span)), eventRow(events, this.span)];
    this.laneRows.replaceChildren(...this.lanes.map(({ element }) => element));
    this.drawStrips();
  }

  private drawStrips(): void {
    this.rows.clear();
    for (const name of this.chosen) {
      const strip = this.index.strips.find((each) => each.name === name);
      if (strip) this.rows.set(name, stripRow(strip, this.span, this.firsts.get(name) ?? 0));
    }
    this.strips.replaceChildren(...[...this.rows.values()].map(({ element }) => element));
  }

  private seekBy(sought: (position: number) => void): void {
    const seek = (event: PointerEvent) => {
      const { left, width } = this.slider.getBoundingClientRect();
      const along = Math.min(1, Math.max(0, (event.clientX - left) / width)); // limited to the axis
      sought(this.span.from + along * lengthOf(this.span));
    };
    onPress(this.slider, (event) => {
      this.slider.setPointerCapture(event.pointerId);
      seek(event);
      return { moved: seek, ended() {} };
    });
  }
}

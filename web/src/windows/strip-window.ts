/** Lanes and strips that fill a window, with the choice of strips and the zoom of the time axis. */

import { button, el, setText } from '../panel/parts/dom';
import { StripChoice } from '../replay/strip-choice';
import { type Timed, Timeline } from '../replay/timeline';

/** Greatest number of strips. */
const MOST_STRIPS = 7;

export interface StripWindowListener {
  /** Called when the user moves the playhead; null if the playhead always stays at the end of the axis. */
  readonly sought: ((position: number) => void) | null;
  /** Changes the length of the time axis: 1 shows less time, −1 shows more time. */
  zoom(way: 1 | -1): void;
}

export class StripWindow {
  readonly element: HTMLElement;
  readonly timeline: Timeline;
  private readonly choice: StripChoice;
  private readonly time = el('b', { class: 'position' });
  private readonly about = el('span');
  private readonly wider: HTMLButtonElement;
  private readonly closer: HTMLButtonElement;

  /** `duration`: longest span of the axis [s]. */
  constructor(timed: Timed, duration: number, listener: StripWindowListener) {
    this.timeline = new Timeline(timed, duration, listener.sought);
    this.choice = new StripChoice(timed.strips, MOST_STRIPS, (names) => this.timeline.choose(names));
    this.wider = button({ 'aria-label': 'Wider', title: 'Show more time' }, ['−'], () => listener.zoom(-1));
    this.closer = button({ 'aria-label': 'Closer', title: 'Show less time' }, ['+'], () => listener.zoom(1));
    this.element = el(
      'main',
      { class: 'band', 'aria-label': 'Strips' },
      el(
        'div',
        { class: 'transport' },
        el('span', { class: 'clock' }, this.time, this.about),
        el('p', { class: 'said' }),
        el('span', { class: 'key commanded' }, 'commanded'),
        el('span', { class: 'key actual' }, 'actual'),
        el('div', { class: 'zoom', role: 'group', 'aria-label': 'Time axis' }, this.wider, this.closer),
        this.choice.element,
      ),
      this.timeline.element,
    );
    this.timeline.choose(this.choice.chosen);
  }

  get chosen(): readonly string[] {
    return this.choice.chosen;
  }

  /** Writes the time of the values, then `about`. `wider`, `closer`: whether the axis can show more or less time. */
  show(time: string, about: string, wider: boolean, closer: boolean): void {
    setText(this.time, time);
    setText(this.about, about);
    this.wider.disabled = !wider;
    this.closer.disabled = !closer;
  }
}

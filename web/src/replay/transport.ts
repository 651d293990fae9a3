/** Controls of a replay: playback, events, time axis, strips, desk, windows. Also shows the time of the playhead. */

import type { PlaybackIndex } from '../link/protocol';
import { button, el, setAttribute, setClass, setPressed, setText } from '../panel/parts/dom';
import { type Player, SPEEDS } from './player';
import { minutes } from './quantity';
import { StripChoice } from './strip-choice';

const SPEED_NAMES: Readonly<Record<number, string>> = { 0.25: '¼', 0.5: '½' };
/** Greatest number of strips. */
const MOST_STRIPS = 4;

export interface TransportListener {
  /** Moves the playhead to the previous or the next event. */
  event(by: 1 | -1): void;
  strips(names: readonly string[]): void;
  desk(): void;
  /** Shows the run's cameras on the monitors again. */
  asFlown(): void;
  /** Shows less (1) or more (−1) of the time axis. */
  zoom(way: 1 | -1): void;
  /** Opens a secondary window. */
  tearOff(what: 'matrix' | 'strips'): void;
}

export class Transport {
  readonly element: HTMLElement;
  private readonly toggle: HTMLButtonElement;
  private readonly speeds;
  private readonly time = el('b', { class: 'position' });
  private readonly status = el('p', { class: 'said' });
  private readonly desk: HTMLButtonElement;
  private readonly asFlown: HTMLButtonElement;
  private readonly wider: HTMLButtonElement;
  private readonly strips: StripChoice;

  constructor(
    index: PlaybackIndex,
    private readonly player: Player,
    listener: TransportListener,
  ) {
    this.strips = new StripChoice(index.strips, MOST_STRIPS, (names) => listener.strips(names));
    this.toggle = button({ class: 'play', title: 'Play or pause: Space' }, [], () => player.toggle());
    this.speeds = SPEEDS.map((speed) => {
      const name = SPEED_NAMES[speed] ?? String(speed);
      return {
        speed,
        key: button({ 'aria-label': `${name}×: speed ${speed}` }, [`${name}×`], () => {
          player.speed = speed;
        }),
      };
    });
    this.desk = button({ title: 'Show the desk of the recorded run: D' }, ['Desk'], () => listener.desk());
    this.asFlown = button(
      { title: 'Show the cameras that the monitors had in the run: A' },
      ['As flown'],
      () => listener.asFlown(),
    );
    this.wider = button({ 'aria-label': 'Wider', title: 'Show more of the run: −' }, ['−'], () =>
      listener.zoom(-1),
    );
    this.element = el(
      'div',
      { class: 'transport', role: 'group', 'aria-label': 'Playing' },
      button({ title: 'Go to the previous event: [' }, ['« event'], () => listener.event(-1)),
      this.toggle,
      button({ title: 'Go to the next event: ]' }, ['event »'], () => listener.event(1)),
      el('span', { class: 'clock' }, this.time, ` of ${minutes(player.duration, 2)}`),
      el(
        'div',
        { class: 'speeds', role: 'group', 'aria-label': 'Speed' },
        ...this.speeds.map(({ key }) => key),
      ),
      this.status,
      el('span', { class: 'key commanded' }, 'commanded'),
      el('span', { class: 'key actual' }, 'actual'),
      el(
        'div',
        { class: 'zoom', role: 'group', 'aria-label': 'Time axis' },
        this.wider,
        button({ 'aria-label': 'Closer', title: 'Show less of the run, around the playhead: +' }, ['+'], () =>
          listener.zoom(1),
        ),
      ),
      this.strips.element,
      this.asFlown,
      this.desk,
      el(
        'div',
        { class: 'own-windows', role: 'group', 'aria-label': 'Own window' },
        button({ title: 'Open all cameras in a secondary window' }, ['Cameras ↗'], () =>
          listener.tearOff('matrix'),
        ),
        button({ title: 'Open lanes and strips in a secondary window' }, ['Strips ↗'], () =>
          listener.tearOff('strips'),
        ),
      ),
    );
    listener.strips(this.strips.chosen);
  }

  /** `status`: a problem, such as missing frames or a blocked window; empty if there is none. `troubled`: a caution. */
  show(status: string, troubled: boolean): void {
    setText(this.toggle, this.player.playing ? 'Pause' : 'Play');
    setPressed(this.toggle, this.player.playing);
    setText(this.time, minutes(this.player.position, 2));
    for (const { speed, key } of this.speeds) setPressed(key, speed === this.player.speed);
    setText(this.status, status);
    setAttribute(this.status, 'title', status);
    setClass(this.element, 'says', status !== '');
    setClass(this.status, 'caution', troubled);
  }

  /** Shows whether the monitors follow the recording; null if the recording does not contain their cameras. */
  setFollowing(on: boolean | null): void {
    setPressed(this.asFlown, on === true);
    this.asFlown.disabled = on === null;
    if (on === null) this.asFlown.title = 'This recording does not contain the cameras of the monitors';
  }

  setZoomed(on: boolean): void {
    this.wider.disabled = !on;
  }

  setDesk(on: boolean): void {
    setPressed(this.desk, on);
    this.strips.disabled = on;
  }

  open(on: boolean): void {
    this.strips.open(on);
  }
}

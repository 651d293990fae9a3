/** Play, pause, speed, time, and what stands below: strips by choice, or the desk as flown. */

import { button, el, setClass, setPressed, setText } from '../panel/dom';
import type { PlaybackIndex } from '../protocol';
import { type Player, SPEEDS } from './player';
import { minutes } from './quantity';

const SPEED_NAMES: Readonly<Record<number, string>> = { 0.25: '¼', 0.5: '½' };
/** Strips that there is room for. */
export const MOST_STRIPS = 4;

export interface TransportListener {
  /** To the event before or after the playhead. */
  event(by: 1 | -1): void;
  strips(names: readonly string[]): void;
  desk(): void;
  /** The monitors show again what they showed in flight. */
  asFlown(): void;
  /** The time axis: more of it, or less. */
  zoom(way: 1 | -1): void;
}

export class Transport {
  readonly element: HTMLElement;
  private readonly toggle: HTMLButtonElement;
  private readonly speeds;
  private readonly time = el('b', { class: 'position' });
  private readonly said = el('p', { class: 'said' });
  private readonly desk: HTMLButtonElement;
  private readonly asFlown: HTMLButtonElement;
  private readonly wider: HTMLButtonElement;
  private readonly list: HTMLElement;
  private readonly more: HTMLButtonElement;
  private readonly choices;
  private chosen: readonly string[];

  constructor(
    index: PlaybackIndex,
    private readonly player: Player,
    private readonly listener: TransportListener,
  ) {
    this.chosen = index.strips.filter((strip) => strip.shown).map(({ name }) => name);
    this.toggle = button({ class: 'play', title: 'Space' }, [], () => player.toggle());
    this.speeds = SPEEDS.map((speed) => {
      const name = SPEED_NAMES[speed] ?? String(speed);
      return {
        speed,
        key: button({ 'aria-label': `Speed ${speed}` }, [`${name}×`], () => {
          player.speed = speed;
        }),
      };
    });
    this.choices = index.strips.map(({ name }) => ({
      name,
      key: button({}, [name], () => this.choose(name)),
    }));
    this.list = el(
      'div',
      { class: 'strip-list', role: 'group', 'aria-label': 'Strips', hidden: '' },
      ...this.choices.map(({ key }) => key),
    );
    this.more = button({ 'aria-expanded': 'false' }, ['Strips'], () => this.open(this.list.hidden === true));
    this.desk = button({ title: 'The desk as it was flown: D' }, ['Desk'], () => listener.desk());
    this.asFlown = button({ title: 'The monitors show what they showed in flight: A' }, ['As flown'], () =>
      listener.asFlown(),
    );
    this.wider = button({ 'aria-label': 'Wider', title: 'More of the run: −' }, ['−'], () =>
      listener.zoom(-1),
    );
    this.element = el(
      'div',
      { class: 'transport', role: 'group', 'aria-label': 'Playing' },
      button({ title: 'The event before: [' }, ['« event'], () => listener.event(-1)),
      this.toggle,
      button({ title: 'The event after: ]' }, ['event »'], () => listener.event(1)),
      el('span', { class: 'clock' }, this.time, ` of ${minutes(player.duration, 2)}`),
      el(
        'div',
        { class: 'speeds', role: 'group', 'aria-label': 'Speed' },
        ...this.speeds.map(({ key }) => key),
      ),
      this.said,
      el('span', { class: 'key commanded' }, 'commanded'),
      el('span', { class: 'key actual' }, 'actual'),
      el(
        'div',
        { class: 'zoom', role: 'group', 'aria-label': 'Time axis' },
        this.wider,
        button({ 'aria-label': 'Closer', title: 'Less of the run, about the playhead: +' }, ['+'], () =>
          listener.zoom(1),
        ),
      ),
      el('div', { class: 'strip-choice' }, this.more, this.list),
      this.asFlown,
      this.desk,
    );
    this.mark();
    listener.strips(this.chosen);
  }

  /** `said`: the last line of the log up to the playhead, or why nothing moves. */
  show(said: string, troubled: boolean): void {
    setText(this.toggle, this.player.playing ? 'Pause' : 'Play');
    setPressed(this.toggle, this.player.playing);
    setText(this.time, minutes(this.player.position, 2));
    for (const { speed, key } of this.speeds) setPressed(key, speed === this.player.speed);
    setText(this.said, said);
    setClass(this.said, 'caution', troubled);
  }

  /** Whether the monitors follow the recording; null: it does not tell what they showed. */
  setFollowing(on: boolean | null): void {
    setPressed(this.asFlown, on === true);
    this.asFlown.disabled = on === null;
    if (on === null) this.asFlown.title = 'This recording does not tell what the monitors showed';
  }

  setZoomed(on: boolean): void {
    this.wider.disabled = !on;
  }

  setDesk(on: boolean): void {
    setPressed(this.desk, on);
    this.more.disabled = on;
    if (on) this.open(false);
  }

  open(on: boolean): void {
    this.list.hidden = !on;
    this.more.setAttribute('aria-expanded', String(on));
  }

  private choose(name: string): void {
    const without = this.chosen.filter((each) => each !== name);
    if (without.length === this.chosen.length) this.chosen = [...this.chosen, name];
    else if (without.length > 0) this.chosen = without;
    this.mark();
    this.listener.strips(this.chosen);
  }

  private mark(): void {
    for (const { name, key } of this.choices) {
      const on = this.chosen.includes(name);
      setPressed(key, on);
      key.disabled = !on && this.chosen.length >= MOST_STRIPS;
    }
  }
}

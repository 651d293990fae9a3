/** Base of every secondary window: its rail, the channel to its page, and the keys that it sends there. */

import { KeyRelay } from '../input/key-relay';
import { type Age, isStale } from '../link/age';
import type { Frame } from '../link/protocol';
import { el, setClass, setText } from '../panel/parts/dom';
import { missionTime } from '../words/format';
import { type PageState, tornOff, type WindowMessage, Windows } from './opened';

/** Time between requests for the page's state [ms]. Without an answer for `SILENT_MS`, the page counts as closed. */
const ASK_MS = 1000;
const SILENT_MS = 5000;

export interface TetherListener {
  heard(message: WindowMessage): void;
  /** Selects the window's monitor in the page, before a key is sent to the page. */
  take?(): void;
  /** Whether a key acts in the window itself, so that it is not sent to the page. */
  own?(code: string): boolean;
}

export interface Words {
  /** Content of the window. */
  readonly name: string;
  readonly title: string;
  /** The recording's file; absent for a live run. */
  readonly file?: string;
  /** Text in the rail while the window's keys act on the page. */
  readonly keys: string;
  /** Text in the rail while the keys do not act on a page. */
  readonly alone: string;
}

/** Texts of a window of a live run, and of a window of a replay. */
export const FLOWN = { keys: 'Keys act here too', alone: 'Observing' };
export const PLAYED = { keys: 'Keys act here too', alone: 'Not linked to a page' };

export class Tether {
  readonly rail: HTMLElement;
  /** Last state that the page has sent; null before the first one, and after the page was closed. */
  page: PageState | null = null;
  private gone = false;
  private heardAt = performance.now();
  /** Whether the window's monitor was selected since the window got the focus. */
  private taken = false;
  private readonly windows: Windows | null;
  private readonly relay: KeyRelay;
  private readonly timer: number;
  private readonly ended = new AbortController();
  private readonly time = el('b');
  private readonly state = el('span', { class: 'who', role: 'status' });

  constructor(
    private readonly words: Words,
    listener: TetherListener,
  ) {
    const of = tornOff(location.search);
    this.windows =
      of === null
        ? null
        : new Windows(of, (message) => {
            this.hear(message);
            listener.heard(message);
          });
    const take = () => {
      this.taken = true;
      listener.take?.();
    };
    this.relay = new KeyRelay(
      (code) => this.page?.takesKeys === true && !listener.own?.(code),
      (message) => {
        if (message.kind === 'key' && !this.taken) take();
        if (message.kind === 'released') this.taken = false;
        this.say(message);
      },
    );
    window.addEventListener('pointerdown', take, { signal: this.ended.signal });
    this.rail = el(
      'header',
      { class: 'rail' },
      el('h1', {}, 'Aftdeck'),
      ...(words.file
        ? [el('b', { class: 'replay-tag' }, 'Replay'), el('span', { class: 'file' }, words.file)]
        : []),
      el('span', { class: 'scenario' }, words.title),
      el('span', {}, words.name),
      el('span', { class: 'space' }),
      el('span', { class: 'met' }, 'MET ', this.time),
      this.state,
    );
    document.title = `${words.name} · ${words.title} · Aftdeck`;
    this.say({ kind: 'ask' });
    this.timer = window.setInterval(() => this.ask(), ASK_MS);
  }

  say(message: WindowMessage): void {
    this.windows?.say(message);
  }

  /** Shows the time and the page's state. If the content is out of date, shows the text `lost` instead of the state. */
  show(time: string, lost = ''): void {
    setText(this.time, time);
    const { keys, alone } = this.words;
    const gone = this.gone ? 'Its page is closed' : '';
    setText(this.state, lost || gone || (this.page?.takesKeys ? keys : alone));
    setClass(this.state, 'lost', lost !== '' || this.gone);
  }

  /** Shows the time of a frame; `age`: age of what the window displays. */
  showAt({ time_s }: Pick<Frame, 'time_s'>, age: Age): void {
    this.show(missionTime(time_s), isStale(age) ? 'Lost' : '');
  }

  dispose(): void {
    clearInterval(this.timer);
    this.ended.abort();
    this.relay.dispose();
    this.windows?.dispose();
  }

  private hear(message: WindowMessage): void {
    if (message.kind === 'gone') this.lose();
    if (message.kind !== 'page' && message.kind !== 'head') return;
    this.heardAt = performance.now();
    this.gone = false;
    if (message.kind === 'page') this.page = message;
  }

  private ask(): void {
    if (this.windows && performance.now() - this.heardAt > SILENT_MS) this.lose();
    this.say({ kind: 'ask' });
  }

  private lose(): void {
    this.gone = true;
    this.page = null;
  }
}

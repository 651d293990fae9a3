/** What every second window has: its rail, the way to the page that it was torn off, and keys that go there. */

import { KeyRelay } from '../input/key-relay';
import { el, setClass, setText } from '../panel/parts/dom';
import { type PageState, type Said, tornOff, Windows } from './opened';

/** It asks what its page shows so often, and takes a page for closed that was silent for so long [ms]. */
const ASK_MS = 1000;
const SILENT_MS = 5000;

export interface TetherListener {
  heard(said: Said): void;
  /** A key is to be passed on: what it acts on is taken in hand first. */
  take?(): void;
  /** Whether a key acts in the window itself. */
  own?(code: string): boolean;
}

export interface Words {
  /** What is shown, and of what. */
  readonly name: string;
  readonly title: string;
  /** The recording's file; absent: what is shown is flown. */
  readonly file?: string;
  /** Its page takes the keys. */
  readonly keys: string;
  /** There is no page that does. */
  readonly alone: string;
}

/** The words of a window whose page flies, and of one whose page plays. */
export const FLOWN = { keys: 'Keys fly here too', alone: 'Watching' };
export const PLAYED = { keys: 'Keys play here too', alone: 'No page plays' };

export class Tether {
  readonly rail: HTMLElement;
  /** State that the page sent last; null before the first. */
  page: PageState | null = null;
  private gone = false;
  private heardAt = performance.now();
  /** What the keys act on was taken in hand since the window got the focus. */
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
        : new Windows(of, (said) => {
            this.hear(said);
            listener.heard(said);
          });
    const take = () => {
      this.taken = true;
      listener.take?.();
    };
    this.relay = new KeyRelay(
      (code) => this.page?.takesKeys === true && !listener.own?.(code),
      (said) => {
        if (said.kind === 'key' && !this.taken) take();
        if (said.kind === 'released') this.taken = false;
        this.say(said);
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

  say(said: Said): void {
    this.windows?.say(said);
  }

  /** `lost`: why what is shown is old, in a word; empty: it is not. */
  show(time: string, lost = ''): void {
    setText(this.time, time);
    const { keys, alone } = this.words;
    const gone = this.gone ? 'Its page is closed' : '';
    setText(this.state, lost || gone || (this.page?.takesKeys ? keys : alone));
    setClass(this.state, 'lost', lost !== '' || this.gone);
  }

  dispose(): void {
    clearInterval(this.timer);
    this.ended.abort();
    this.relay.dispose();
    this.windows?.dispose();
  }

  private hear(said: Said): void {
    if (said.kind === 'gone') this.lose();
    if (said.kind !== 'page' && said.kind !== 'head') return;
    this.heardAt = performance.now();
    this.gone = false;
    if (said.kind === 'page') this.page = said;
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

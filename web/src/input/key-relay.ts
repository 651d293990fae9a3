/** Keys pressed in a second window, passed to its page, which takes them as its own. */

import { isControl, isTyping } from './keyboard';
import { mappingOf } from './store';

export type Relayed =
  | {
      readonly kind: 'key';
      readonly down: boolean;
      readonly code: string;
      readonly key: string;
      readonly shift: boolean;
    }
  /** Keys are held still. */
  | { readonly kind: 'holding' }
  /** The window lost the focus: every key is let go. */
  | { readonly kind: 'released' };

/** Interval of the messages while keys are held [ms]. */
const HOLDING_MS = 100;
/** A window silent for this long holds no key any more [ms]; as the station has it for sticks. */
const SILENT_MS = 500;

/** The second window's end. */
export class KeyRelay {
  private readonly held = new Set<string>();
  private readonly ended = new AbortController();
  private readonly timer: number;

  /** `passes`: whether there is a page that takes this key. */
  constructor(
    private readonly passes: (code: string) => boolean,
    private readonly say: (said: Relayed) => void,
  ) {
    const options = { capture: true, signal: this.ended.signal };
    window.addEventListener('keydown', (event) => this.down(event), options);
    window.addEventListener('keyup', (event) => this.up(event), options);
    for (const gone of ['blur', 'pagehide']) window.addEventListener(gone, () => this.release(), options);
    document.addEventListener('visibilitychange', () => document.hidden && this.release(), options);
    this.timer = window.setInterval(() => {
      if (this.held.size > 0) say({ kind: 'holding' });
    }, HOLDING_MS);
  }

  dispose(): void {
    this.release();
    clearInterval(this.timer);
    this.ended.abort();
  }

  private down(event: KeyboardEvent): void {
    const { code, key, target, shiftKey: shift } = event;
    if (!this.passes(code) || event.ctrlKey || event.altKey || event.metaKey || code === 'Tab') return;
    if (isTyping(target) || (key === 'Enter' && isControl(target))) return;
    if (key === '?' || code in mappingOf('keyboard').bindings) event.preventDefault();
    event.stopImmediatePropagation();
    if (event.repeat || this.held.has(code)) return;
    this.held.add(code);
    this.say({ kind: 'key', down: true, code, key, shift });
  }

  private up(event: KeyboardEvent): void {
    const { code, key, shiftKey: shift } = event;
    if (code === 'Space') event.preventDefault(); // or a button in focus would take it as its click
    if (!this.held.delete(code)) return;
    event.stopImmediatePropagation();
    this.say({ kind: 'key', down: false, code, key, shift });
  }

  private release(): void {
    this.held.clear();
    this.say({ kind: 'released' });
  }
}

/** The end of the page that flies or plays. */
export class RelayedKeys {
  private readonly held = new Set<string>();
  private heard = 0;
  private readonly timer: number;

  /** `zero`: lets go of every key and stick at once. */
  constructor(private readonly zero: () => void) {
    this.timer = window.setInterval(() => {
      if (this.held.size > 0 && performance.now() - this.heard > SILENT_MS) this.release();
    }, HOLDING_MS);
  }

  take(said: Relayed): void {
    this.heard = performance.now();
    if (said.kind === 'released') this.release();
    if (said.kind !== 'key') return;
    const { down, code, key, shift: shiftKey } = said;
    if (down) this.held.add(code);
    else this.held.delete(code);
    const type = down ? 'keydown' : 'keyup';
    const init = { code, key, shiftKey, bubbles: true, cancelable: true };
    document.body.dispatchEvent(new KeyboardEvent(type, init));
  }

  dispose(): void {
    clearInterval(this.timer);
  }

  private release(): void {
    this.held.clear();
    this.zero();
  }
}

/** Sends the keys pressed in a secondary window to the window's page, which handles them like its own keys. */

import { isControl, isTyping } from './keyboard';
import { mappingOf } from './store';
import { whenSwallowed } from './swallowed';

export type Relayed =
  | {
      readonly kind: 'key';
      readonly down: boolean;
      readonly repeat: boolean;
      readonly code: string;
      readonly key: string;
      readonly shift: boolean;
    }
  /** At least one key is still held. */
  | { readonly kind: 'holding' }
  /** The window may not receive the release of a key: all keys are released. */
  | { readonly kind: 'released' };

/** Time between two messages while keys are held [ms]. */
const HOLDING_MS = 100;
/** If no message arrives for this time, a window's keys count as released [ms]. Equal to the station's `SILENCE`. */
const SILENT_MS = 500;

/** Sender in the secondary window. */
export class KeyRelay {
  private readonly held = new Set<string>();
  private readonly ended = new AbortController();
  private readonly timer: number;

  /** `passes` returns whether there is a page that handles this key. */
  constructor(
    private readonly passes: (code: string) => boolean,
    private readonly say: (message: Relayed) => void,
  ) {
    const options = { capture: true, signal: this.ended.signal };
    whenSwallowed(() => this.release(), this.ended.signal); // first: other listeners may stop the events
    window.addEventListener('keydown', (event) => this.down(event), options);
    window.addEventListener('keyup', (event) => this.up(event), options);
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
    const { code, key, repeat, target, shiftKey: shift } = event;
    if (!this.passes(code) || event.ctrlKey || event.altKey || event.metaKey || code === 'Tab') return;
    if (isTyping(target) || (key === 'Enter' && isControl(target))) return;
    if (key === '?' || code in mappingOf('keyboard').bindings) event.preventDefault();
    event.stopImmediatePropagation();
    if (!repeat) this.held.add(code);
    if (this.held.has(code)) this.say({ kind: 'key', down: true, repeat, code, key, shift });
  }

  private up(event: KeyboardEvent): void {
    const { code, key, shiftKey: shift } = event;
    if (code === 'Space') event.preventDefault(); // otherwise Space would click the button in focus
    if (!this.held.delete(code)) return;
    event.stopImmediatePropagation();
    this.say({ kind: 'key', down: false, repeat: false, code, key, shift });
  }

  private release(): void {
    this.held.clear();
    this.say({ kind: 'released' });
  }
}

/** Receiver in the page. */
export class RelayedKeys {
  private readonly held = new Set<string>();
  private heard = 0;
  private readonly timer: number;

  /** `zero` releases all keys and centres all sticks. */
  constructor(private readonly zero: () => void) {
    this.timer = window.setInterval(() => {
      if (this.held.size > 0 && performance.now() - this.heard > SILENT_MS) this.release();
    }, HOLDING_MS);
  }

  take(message: Relayed): void {
    this.heard = performance.now();
    if (message.kind === 'released') this.release();
    if (message.kind !== 'key') return;
    const { down, repeat, code, key, shift: shiftKey } = message;
    if (down) this.held.add(code);
    else this.held.delete(code);
    const type = down ? 'keydown' : 'keyup';
    const init = { code, key, repeat, shiftKey, bubbles: true, cancelable: true };
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

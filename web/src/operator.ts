/** The operator's hands: devices into sticks and actions, and everything that takes the sticks to zero. */

import { Pad } from './input/gamepad';
import { isTyping, Keyboard } from './input/keyboard';
import type { Action } from './input/keymap';
import { Sticks } from './input/sticks';
import type { Latency } from './latency';
import { setClass } from './panel/dom';
import type { Command } from './socket';

/** Devices are read this often, even where pictures are drawn more slowly [ms]. */
const TICK_MS = 15;

export interface OperatorListener {
  acted(action: Action): void;
  send(command: Command): number;
}

export class Operator {
  readonly pad: Pad;
  readonly keyboard: Keyboard;
  readonly sticks: Sticks;
  /** Only the page that flies moves the sticks. */
  flying = false;
  private readonly timer: number;
  private readonly ended = new AbortController();

  constructor(latency: Latency, listener: OperatorListener) {
    const acted = (action: Action) => {
      if (action.name === 'stop') this.sticks.zero();
      listener.acted(action);
    };
    this.pad = new Pad(acted);
    this.keyboard = new Keyboard({
      moved: (at) => {
        if (this.flying) this.sticks.moved(at);
      },
      acted,
    });
    this.sticks = new Sticks(this.keyboard, this.pad, latency, (command) => listener.send(command));

    const options = { signal: this.ended.signal };
    window.addEventListener('blur', () => this.sticks.zero(), options);
    window.addEventListener('pagehide', () => this.sticks.zero(), options);
    document.addEventListener('visibilitychange', () => document.hidden && this.sticks.zero(), options);
    document.addEventListener('focusin', (event) => this.focused(event.target), options);
    document.addEventListener('focusout', () => this.focused(null), options);
    this.timer = window.setInterval(() => this.tick(performance.now()), TICK_MS);
  }

  /** Reads the devices; a page that nobody sees or that only watches has its sticks at zero. */
  tick(now: number): void {
    if (this.flying && !document.hidden) this.sticks.tick(now);
    else this.sticks.zero();
  }

  dispose(): void {
    clearInterval(this.timer);
    this.ended.abort();
    this.keyboard.dispose();
  }

  private focused(target: EventTarget | null): void {
    const typing = isTyping(target);
    if (typing) this.keyboard.release();
    setClass(document.body, 'typing', typing);
  }
}

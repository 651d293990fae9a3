/** The operator's hands: devices into sticks and actions, and everything that takes the sticks to zero. */

import { STILL, type Turning, turningOf } from '../input/camera-hand';
import { Controllers } from '../input/controllers';
import { isTyping } from '../input/keyboard';
import type { Action } from '../input/keymap';
import { Sticks } from '../input/sticks';
import { mappingOf } from '../input/store';
import type { Latency } from '../link/latency';
import type { Command } from '../link/socket';
import { setClass } from '../panel/parts/dom';

/** Devices are read this often, even where pictures are drawn more slowly [ms]. */
const TICK_MS = 15;

/** A page that did nothing for so long, or heard nothing, asks for its sticks at zero; the station does as well [ms]. */
export const LOST_MS = 2000;

/** What keys and buttons do even while controllers are looked at and changed. */
const always = (action: Action) =>
  action.name === 'stop' || action.name === 'leave' || (action.name === 'grip' && action.grip === 'brakes');

export interface OperatorListener {
  acted(action: Action): void;
  send(command: Command): number;
  /** Every key passes here first; true where it was taken for something else. */
  taken(event: KeyboardEvent): boolean;
}

export class Operator {
  readonly controllers: Controllers;
  readonly sticks: Sticks;
  /** Only the page that flies moves the sticks. */
  flying = false;
  private ticked = 0;
  private readonly timer: number;
  private readonly ended = new AbortController();

  constructor(
    latency: Latency,
    private readonly listener: OperatorListener,
  ) {
    const acted = (action: Action) => {
      if (action.name === 'stop') this.sticks.zero();
      if (!this.controllers.paused || always(action)) listener.acted(action);
    };
    this.controllers = new Controllers(acted, {
      moved: (at) => {
        if (this.flying && !document.hidden) this.sticks.moved(at);
      },
      taken: (event) => listener.taken(event),
    });
    this.sticks = new Sticks(this.controllers, latency, (command) => listener.send(command));

    const options = { signal: this.ended.signal };
    window.addEventListener('blur', () => this.sticks.zero(), options);
    window.addEventListener('pagehide', () => this.sticks.zero(), options);
    document.addEventListener('visibilitychange', () => document.hidden && this.hidden(), options);
    document.addEventListener('focusin', (event) => this.focused(event.target), options);
    document.addEventListener('focusout', () => this.focused(null), options);
    document.addEventListener('pointerdown', (event) => this.pointed(event), options);
    this.timer = window.setInterval(() => this.tick(performance.now()), TICK_MS);
  }

  /** Read the devices. On a hidden page and on an observer's page the sticks are zero. */
  tick(now: number): void {
    if (this.ticked > 0 && now - this.ticked > LOST_MS) this.sticks.zero();
    this.ticked = now;
    if ((this.flying || this.controllers.paused) && !document.hidden) this.sticks.tick(now);
    else this.sticks.zero();
  }

  /** How the switches of the camera in hand are pushed; who only watches has the keyboard's, for views of its own. */
  get turning(): Turning {
    if (this.controllers.paused) return STILL;
    const watched = turningOf(this.controllers.keyboard.held, mappingOf('keyboard'));
    return this.flying ? this.sticks.camera : watched;
  }

  /** Zero the sticks at once; a held key acts only when it is pressed again. */
  zero(): void {
    this.sticks.zero();
  }

  dispose(): void {
    clearInterval(this.timer);
    this.ended.abort();
    this.controllers.dispose();
  }

  /** Nobody sees the arm. */
  private hidden(): void {
    this.sticks.zero();
    if (this.flying) this.listener.send({ type: 'hands_off', cause: 'page hidden' });
  }

  private focused(target: EventTarget | null): void {
    const typing = isTyping(target);
    if (typing) this.controllers.keyboard.release();
    setClass(document.body, 'typing', typing);
  }

  /** Whoever uses a finger is shown sticks for it. */
  private pointed({ pointerType }: PointerEvent): void {
    if (pointerType === 'touch') this.controllers.touch.touched();
  }
}

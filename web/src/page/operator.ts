/** The operator's inputs: converts the devices' readings to sticks and actions, and centres the sticks if required. */

import type { Action } from '../input/action';
import { STILL, type Turning, turningOf } from '../input/camera-hand';
import { Controllers } from '../input/controllers';
import { isTyping } from '../input/keyboard';
import { Sticks } from '../input/sticks';
import { mappingOf } from '../input/store';
import { whenSwallowed } from '../input/swallowed';
import type { Latency } from '../link/latency';
import type { Command } from '../link/socket';
import { setClass } from '../panel/parts/dom';

/** Time between two readings of the devices, even if pictures take longer [ms]. */
const TICK_MS = 15;

/** Time without a tick or a frame after which the page centres the sticks [ms]; the station centres them, too. */
export const LOST_MS = 2000;

/** Whether an action is allowed while the sheet of controllers is open. */
const always = (action: Action) =>
  action.name === 'stop' || action.name === 'leave' || (action.name === 'grip' && action.grip === 'brakes');

export interface OperatorListener {
  acted(action: Action): void;
  send(command: Command): number;
  /** Called first with every key event; returns true if it has used the event, which then has no other effect. */
  taken(event: KeyboardEvent): boolean;
  /** A key of the arm was pressed while the sticks do not move the arm. */
  pressedInVain(): void;
}

export class Operator {
  readonly controllers: Controllers;
  readonly sticks: Sticks;
  /** Whether the sticks move the arm; otherwise they are centred. */
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
    whenSwallowed(() => this.sticks.zero(), this.ended.signal); // first: other listeners may stop the events
    this.controllers = new Controllers(acted, {
      moved: (at) => {
        if (this.flying && !document.hidden) this.sticks.moved(at);
        else if (!this.flying && this.controllers.keyboard.commandsArm) listener.pressedInVain();
      },
      taken: (event) => listener.taken(event),
    });
    this.sticks = new Sticks(this.controllers, latency, (command) => listener.send(command));

    const options = { signal: this.ended.signal };
    document.addEventListener('visibilitychange', () => document.hidden && this.hidden(), options);
    document.addEventListener('focusin', (event) => this.focused(event.target), options);
    document.addEventListener('focusout', () => this.focused(null), options);
    document.addEventListener('pointerdown', (event) => this.pointed(event), options);
    this.timer = window.setInterval(() => this.tick(performance.now()), TICK_MS);
  }

  /** Reads the devices. On a hidden page and on an observer's page the sticks are centred. */
  tick(now: number): void {
    if (this.ticked > 0 && now - this.ticked > LOST_MS) this.sticks.zero();
    this.ticked = now;
    if ((this.flying || this.controllers.paused) && !document.hidden) this.sticks.tick(now);
    else this.sticks.zero();
  }

  /** Deflections of the selected camera's switches. An observer's keys also deflect them, to move engineering views. */
  get turning(): Turning {
    if (this.controllers.paused) return STILL;
    const byKeyboard = turningOf(this.controllers.keyboard.held, mappingOf('keyboard'));
    return this.flying ? this.sticks.camera : byKeyboard;
  }

  /** Centres the sticks at once; a held key acts only when it is pressed again. */
  zero(): void {
    this.sticks.zero();
  }

  dispose(): void {
    clearInterval(this.timer);
    this.ended.abort();
    this.controllers.dispose();
  }

  /** Reports that the page is hidden. */
  private hidden(): void {
    if (this.flying) this.listener.send({ type: 'hands_off', cause: 'page hidden' });
  }

  private focused(target: EventTarget | null): void {
    const typing = isTyping(target);
    if (typing) this.controllers.keyboard.release();
    setClass(document.body, 'typing', typing);
  }

  /** Shows the touch sticks at a touch, unless the user has hidden them. */
  private pointed({ pointerType }: PointerEvent): void {
    if (pointerType === 'touch') this.controllers.touch.touched();
  }
}

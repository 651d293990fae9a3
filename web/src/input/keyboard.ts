/** The keyboard as two hand controllers and a row of switches. */

import { CAMERA_KEYS } from './camera-hand';
import { type Deflection, map, ZERO } from './deflection';
import { ACTION_KEYS, type Action, AXIS_KEYS, GRIP_KEYS } from './keymap';

/** A held key reaches full deflection in this time, a released one zero [s]. */
const FULL_S = 0.35;
const RETURN_S = 0.15;

/** An axis `dt` [s] later on its way from `value` to `target`; it changes sides through zero. */
export function ramp(value: number, target: number, dt: number): number {
  const crossing = value * target < 0;
  const goal = crossing ? 0 : target;
  const growing = Math.abs(goal) > Math.abs(value);
  const step = dt / (growing ? FULL_S : RETURN_S);
  return Math.abs(goal - value) <= step ? goal : value + Math.sign(goal - value) * step;
}

export interface KeyboardListener {
  /** A flying key went down or up at `at` [ms, as performance.now()]. */
  moved(at: number): void;
  acted(action: Action): void;
}

export class Keyboard {
  readonly held = new Set<string>();
  private value: Deflection = ZERO;
  private readonly ended = new AbortController();

  constructor(private readonly listener: KeyboardListener) {
    const options = { capture: true, signal: this.ended.signal };
    window.addEventListener('keydown', (event) => this.down(event), options);
    window.addEventListener('keyup', (event) => this.up(event), options);
  }

  /** Deflection `dt` [s] after the last call. */
  step(dt: number): Deflection {
    const target = ZERO.map(() => 0);
    for (const code of this.held) {
      const key = AXIS_KEYS.get(code);
      if (key) target[key.axis] = (target[key.axis] ?? 0) + key.sign;
    }
    this.value = map((axis) => ramp(this.value[axis] ?? 0, target[axis] ?? 0, dt));
    return this.value;
  }

  /** Lets go of every key at once; a key still held must be pressed anew. */
  release(): void {
    const held = [...this.held];
    this.held.clear();
    this.value = ZERO;
    for (const code of held) this.grip(code, false, performance.now());
  }

  dispose(): void {
    this.ended.abort();
  }

  private down(event: KeyboardEvent): void {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const action = actionOf(event);
    if (action?.name !== 'stop' && action?.name !== 'close') {
      if (isTyping(event.target)) return;
      if (action?.name === 'enter' && isControl(event.target)) return;
    }
    if (action) {
      event.preventDefault();
      if (!event.repeat) this.listener.acted(action);
    } else if (CAMERA_KEYS.has(event.code) && !isSlider(event.target)) {
      event.preventDefault();
      if (!event.repeat) this.held.add(event.code);
    } else if (AXIS_KEYS.has(event.code) || GRIP_KEYS.has(event.code)) {
      event.preventDefault();
      if (event.repeat || this.held.has(event.code)) return;
      this.held.add(event.code);
      if (!this.grip(event.code, true, event.timeStamp)) this.listener.moved(event.timeStamp);
    }
  }

  private up(event: KeyboardEvent): void {
    // A button takes the click of Space on release; Space is stop and nothing else.
    if (event.code === 'Space') event.preventDefault();
    if (!this.held.delete(event.code) || CAMERA_KEYS.has(event.code)) return;
    if (!this.grip(event.code, false, event.timeStamp)) this.listener.moved(event.timeStamp);
  }

  /** Passes on a key that is held to act; false where it is none. */
  private grip(code: string, down: boolean, at: number): boolean {
    const grip = GRIP_KEYS.get(code);
    if (grip) this.listener.acted({ name: 'grip', grip, down, at });
    return grip !== undefined;
  }
}

function actionOf(event: KeyboardEvent): Action | undefined {
  return event.key === '?' ? { name: 'keys' } : ACTION_KEYS.get(event.code);
}

export function isTyping(target: EventTarget | null): target is HTMLInputElement {
  return target instanceof HTMLInputElement;
}

/** Arrows and page keys are a slider's own. */
function isSlider(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && target.matches('[role=slider]');
}

function isControl(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && target.matches('button, a[href], summary');
}

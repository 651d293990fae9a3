/** The keyboard as two hand controllers and switches, according to its mapping. */

import { clamp } from '../basics/clamp';
import type { Action } from './action';
import { type Deflection, isZero, PAN, ZERO } from './deflection';
import { NOT_HELD } from './hold';
import { USES } from './keymap';
import { learnLetter } from './layout';
import { Repeats } from './repeats';
import { mappingOf } from './store';
import type { Use } from './uses/use';

/** Time from zero to full deflection while a key is held, and time back to zero after its release [s]. */
const FULL_S = 0.35;
const RETURN_S = 0.15;

/**
 * Moves an axis from `value` towards `target` for `dt` [s] and returns its new value. If `value` and `target` differ in
 * sign, the axis stops at zero first.
 */
export function ramp(value: number, target: number, dt: number): number {
  const crossing = value * target < 0;
  const goal = crossing ? 0 : target;
  const growing = Math.abs(goal) > Math.abs(value);
  const step = dt / (growing ? FULL_S : RETURN_S);
  return Math.abs(goal - value) <= step ? goal : value + Math.sign(goal - value) * step;
}

export interface KeyboardListener {
  /** A stick's key was pressed or released at `at` [ms, as performance.now()]. */
  moved(at: number): void;
  acted(action: Action): void;
  /** Called first with every key event; returns true if it has used the event, which then has no other effect. */
  taken(event: KeyboardEvent): boolean;
}

export class Keyboard {
  readonly held = new Set<string>();
  /** Present deflections. */
  value: Deflection = ZERO;
  private readonly repeats = new Repeats();
  /** Keys that count as released because their repeats have stopped; a later repeat presses them again. */
  private readonly lapsed = new Set<string>();
  private readonly ended = new AbortController();

  constructor(private readonly listener: KeyboardListener) {
    const options = { capture: true, signal: this.ended.signal };
    window.addEventListener('keydown', (event) => this.down(event), options);
    window.addEventListener('keyup', (event) => this.up(event), options);
  }

  /** Deflections that the held keys command. */
  get target(): Deflection {
    const target = ZERO.map(() => 0);
    for (const code of this.held) {
      const does = useOf(code)?.does;
      if (does?.kind === 'axis') target[does.axis] = (target[does.axis] ?? 0) + does.sign;
    }
    return target.map((value) => clamp(value));
  }

  /** Whether the key of PULSE is held. */
  get pulsing(): boolean {
    return [...this.held].some((code) => useOf(code)?.does.kind === 'pulse');
  }

  /** Whether the held keys command the arm. */
  get commandsArm(): boolean {
    return !isZero(this.target.slice(0, PAN));
  }

  /** Moves the deflections for `dt` [s] towards `target`, until `now` [ms], and returns them. */
  step(dt: number, now: number): Deflection {
    const stopped = this.repeats.stopped(now);
    if (stopped !== null && this.held.delete(stopped)) {
      this.lapsed.add(stopped);
      this.grip(stopped, false, NOT_HELD);
    }
    const { target } = this;
    // A tap with PULSE must ask for its pulse, however short it is.
    this.value = this.pulsing
      ? target
      : ZERO.map((_, axis) => ramp(this.value[axis] ?? 0, target[axis] ?? 0, dt));
    return this.value;
  }

  /** Releases all keys; a held key acts only when it is pressed again. */
  release(): void {
    const held = [...this.held];
    this.held.clear();
    this.lapsed.clear();
    this.value = ZERO;
    for (const code of held) this.grip(code, false, NOT_HELD);
  }

  dispose(): void {
    this.ended.abort();
  }

  private down(event: KeyboardEvent): void {
    learnLetter(event);
    this.repeats.heard(event);
    if (this.listener.taken(event)) {
      event.preventDefault();
      event.stopImmediatePropagation();
      return;
    }
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const use = useOf(event.code);
    const does = use?.does;
    const once = does?.kind === 'once' || does?.kind === 'view';
    const name = event.key === '?' ? 'keys' : once ? use?.name : undefined;
    if (name !== 'stop' && name !== 'leave') {
      if (isTyping(event.target) || isOwn(event)) return;
      if (name === 'enter' && isControl(event.target)) return;
    }
    if (name) {
      if (!takesSpaces(event.target)) event.preventDefault();
      if (!event.repeat) this.listener.acted({ name });
    } else if (does) {
      event.preventDefault();
      const lapsed = this.lapsed.delete(event.code);
      if (this.held.has(event.code) || (event.repeat && !(lapsed && does.kind === 'axis'))) return;
      this.held.add(event.code);
      if (!this.grip(event.code, true, event.timeStamp)) this.listener.moved(event.timeStamp);
    }
  }

  private up(event: KeyboardEvent): void {
    // Space must only act as STOP; without this line, its release would also click the button in focus.
    if (event.code === 'Space') event.preventDefault();
    this.repeats.heard(event);
    this.lapsed.delete(event.code);
    if (!this.held.delete(event.code)) return;
    if (!this.grip(event.code, false, event.timeStamp)) this.listener.moved(event.timeStamp);
  }

  /** Handles a key that acts when held; returns false for other keys. */
  private grip(code: string, down: boolean, at: number): boolean {
    const does = useOf(code)?.does;
    if (does?.kind === 'grip') this.listener.acted({ name: 'grip', grip: does.grip, down, at });
    return does?.kind === 'grip';
  }
}

function useOf(code: string): Use | undefined {
  const name = mappingOf('keyboard').bindings[code];
  return name === undefined ? undefined : USES.get(name);
}

/** Returns whether an element is a field into which letters can be typed, unlike a slider or a check box. */
export function isTyping(target: EventTarget | null): target is HTMLInputElement {
  return target instanceof HTMLInputElement && !/^(?:range|checkbox|radio|button)$/.test(target.type);
}

/** Returns whether an element is a text field into which spaces can be typed. */
function takesSpaces(target: EventTarget | null): boolean {
  return isTyping(target) && target.inputMode === 'text';
}

/** Returns whether the element in focus handles this key, as a slider or a row of keys handles the arrow keys. */
function isOwn({ code, target }: KeyboardEvent): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (/^Arrow(Left|Right)$/.test(code) && target.closest('[data-row]')) return isForCameras(code);
  return (
    /^(Arrow|Page|Home|End)/.test(code) && target.matches('[role=slider], [type=range], select, [role=tab]')
  );
}

/** Returns whether a key has no function, or deflects an axis of the cameras. */
export function isForCameras(code: string): boolean {
  const does = useOf(code)?.does;
  return does === undefined || (does.kind === 'axis' && does.axis >= PAN);
}

export function isControl(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && target.matches('button, a[href], summary, select');
}

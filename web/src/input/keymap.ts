/** What each key does, by its place on the keyboard (`KeyboardEvent.code`). */

import { PITCH, ROLL, TELESCOPE, X, Y, YAW, Z } from './deflection';

/** What is held for a while before it acts: close or open the hand, latch or unlatch what it holds. */
export type Grip = 'close' | 'open' | 'latch';

export type Action =
  | {
      readonly name:
        | 'stop'
        | 'rate'
        | 'rate hold'
        | 'proceed'
        | 'enter'
        | 'other monitor'
        | 'acknowledge'
        | 'plane'
        | 'matrix'
        | 'split'
        | 'slow camera'
        | 'fly orbiter'
        | 'keys'
        | 'close';
    }
  | { readonly name: 'turn mode' | 'turn joint' | 'step camera'; readonly by: 1 | -1 }
  | { readonly name: 'camera'; readonly index: number }
  | GripAction;

export interface GripAction {
  readonly name: 'grip';
  readonly grip: Grip;
  readonly down: boolean;
  /** When it went down or up [ms, as performance.now()]. */
  readonly at: number;
}

export interface AxisKey {
  readonly axis: number;
  readonly sign: 1 | -1;
}

/** Keys that deflect a stick while held. */
export const AXIS_KEYS: ReadonlyMap<string, AxisKey> = new Map<string, AxisKey>([
  ['KeyW', { axis: X, sign: 1 }],
  ['KeyS', { axis: X, sign: -1 }],
  ['KeyD', { axis: Y, sign: 1 }],
  ['KeyA', { axis: Y, sign: -1 }],
  ['KeyE', { axis: Z, sign: 1 }],
  ['KeyQ', { axis: Z, sign: -1 }],
  ['KeyI', { axis: PITCH, sign: 1 }],
  ['KeyK', { axis: PITCH, sign: -1 }],
  ['KeyL', { axis: YAW, sign: 1 }],
  ['KeyJ', { axis: YAW, sign: -1 }],
  ['KeyO', { axis: ROLL, sign: 1 }],
  ['KeyU', { axis: ROLL, sign: -1 }],
  ['KeyY', { axis: TELESCOPE, sign: 1 }],
  ['KeyN', { axis: TELESCOPE, sign: -1 }],
]);

/** Keys that act once they were held long enough. */
export const GRIP_KEYS: ReadonlyMap<string, Grip> = new Map<string, Grip>([
  ['KeyG', 'close'],
  ['KeyR', 'open'],
  ['KeyT', 'latch'],
]);

/** Keys that do something once per press. */
export const ACTION_KEYS: ReadonlyMap<string, Action> = new Map<string, Action>([
  ['Space', { name: 'stop' }],
  ['KeyV', { name: 'rate' }],
  ['KeyH', { name: 'rate hold' }],
  ['KeyP', { name: 'proceed' }],
  ['BracketLeft', { name: 'turn mode', by: -1 }],
  ['BracketRight', { name: 'turn mode', by: 1 }],
  ['Enter', { name: 'enter' }],
  ['NumpadEnter', { name: 'enter' }],
  ['Minus', { name: 'turn joint', by: -1 }],
  ['Equal', { name: 'turn joint', by: 1 }],
  ['Comma', { name: 'step camera', by: -1 }],
  ['Period', { name: 'step camera', by: 1 }],
  ['KeyX', { name: 'other monitor' }],
  ['KeyM', { name: 'acknowledge' }],
  ['KeyF', { name: 'plane' }],
  ['KeyC', { name: 'matrix' }],
  ['KeyZ', { name: 'split' }],
  ['Semicolon', { name: 'slow camera' }],
  ['Backquote', { name: 'fly orbiter' }],
  ['Escape', { name: 'close' }],
  ...Array.from({ length: 10 }, (_, i): [string, Action] => [
    `Digit${(i + 1) % 10}`,
    { name: 'camera', index: i },
  ]),
]);

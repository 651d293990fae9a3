/** What each key does, by its place on the keyboard (`KeyboardEvent.code`). */

import { PITCH, ROLL, X, Y, YAW, Z } from './deflection';

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
        | 'keys'
        | 'close';
    }
  | { readonly name: 'turn mode' | 'turn joint' | 'step camera'; readonly by: 1 | -1 }
  | { readonly name: 'camera'; readonly index: number };

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
  ['Escape', { name: 'close' }],
  ...Array.from({ length: 9 }, (_, i): [string, Action] => [`Digit${i + 1}`, { name: 'camera', index: i }]),
]);

/**
 * All functions that can be assigned to keys, buttons and axes; the code calls a function a `use`. A new function needs
 * an entry in `USES`, its key in `defaults.ts`, and for an action a case in `page/commands.ts`. The sheet, the storage,
 * the rebinding and the recording read all functions from `USES`.
 */

import { AXES } from './deflection';

/** Functions that act after a hold: close or open the end effector, latch or unlatch a payload, release the brakes. */
export type Grip = 'close' | 'open' | 'latch' | 'brakes';

export type Action =
  | {
      readonly name:
        | 'stop'
        | 'rate'
        | 'rate hold'
        | 'pulse'
        | 'safing'
        | 'position hold'
        | 'proceed'
        | 'enter'
        | 'otherMonitor'
        | 'split'
        | 'matrix'
        | 'offered pair'
        | 'acknowledge'
        | 'announce'
        | 'mute'
        | 'plane'
        | 'bending'
        | 'slow camera'
        | 'fly orbiter'
        | 'light'
        | 'lock exposure'
        | 'control page'
        | 'keys'
        | 'leave';
    }
  | { readonly name: 'turn mode' | 'turn joint' | 'cameraStep'; readonly by: 1 | -1 }
  | { readonly name: 'camera'; readonly number: number }
  | GripAction;

export interface GripAction {
  readonly name: 'grip';
  readonly grip: Grip;
  readonly down: boolean;
  /** Time of the press or release [ms, as performance.now()]. */
  readonly at: number;
}

/**
 * Effect of a function: it deflects an axis to one side, acts once at each press, acts after a hold (`Grip`), or is
 * PULSE: a key switches it on while it is held, and each press of a button switches it on or off.
 */
export type Does =
  | { readonly kind: 'axis'; readonly axis: number; readonly sign: 1 | -1 }
  | { readonly kind: 'once'; readonly action: Exclude<Action, GripAction> }
  | { readonly kind: 'grip'; readonly grip: Grip }
  | { readonly kind: 'pulse' };

export interface Use {
  /** Name in a mapping: `+X`, `rate hold`, `camera 3`. */
  readonly name: string;
  /** Name on the page. */
  readonly label: string;
  readonly does: Does;
}

const AXIS_WORDS: readonly (readonly [minus: string, plus: string])[] = [
  ['THC −X', 'THC +X'],
  ['THC −Y', 'THC +Y'],
  ['THC −Z', 'THC +Z'],
  ['RHC −roll', 'RHC +roll'],
  ['RHC −pitch', 'RHC +pitch'],
  ['RHC −yaw', 'RHC +yaw'],
  ['telescope shorter', 'telescope longer'],
  ['pan left', 'pan right'],
  ['tilt down', 'tilt up'],
  ['zoom out', 'zoom in'],
];

function axisUses(): readonly Use[] {
  return AXES.flatMap((name, axis) =>
    ([-1, 1] as const).map((sign) => ({
      name: `${sign < 0 ? '-' : '+'}${name}`,
      label: AXIS_WORDS[axis]?.[sign < 0 ? 0 : 1] ?? name,
      does: { kind: 'axis', axis, sign } as const,
    })),
  );
}

function once(name: string, label: string, action: Exclude<Action, GripAction>): Use {
  return { name, label, does: { kind: 'once', action } };
}

function held(grip: Grip, label: string): Use {
  return { name: grip, label, does: { kind: 'grip', grip } };
}

/** Number of cameras that have a key. */
const CAMERAS = 10;

const ACTIONS: readonly Use[] = [
  once('stop', 'stop', { name: 'stop' }),
  once('rate', 'coarse, vernier', { name: 'rate' }),
  once('rate hold', 'rate hold', { name: 'rate hold' }),
  { name: 'pulse', label: 'pulse', does: { kind: 'pulse' } },
  held('close', 'capture, close'),
  held('open', 'release, open'),
  held('latch', 'latch, unlatch'),
  held('brakes', 'brakes'),
  once('safing', 'safing', { name: 'safing' }),
  once('position hold', 'position hold', { name: 'position hold' }),
  once('mode -', 'previous mode', { name: 'turn mode', by: -1 }),
  once('mode +', 'next mode', { name: 'turn mode', by: 1 }),
  once('enter', 'enter mode', { name: 'enter' }),
  once('proceed', 'proceed', { name: 'proceed' }),
  once('joint -', 'previous joint', { name: 'turn joint', by: -1 }),
  once('joint +', 'next joint', { name: 'turn joint', by: 1 }),
  once('fly orbiter', 'THC to orbiter', { name: 'fly orbiter' }),
  once('acknowledge', 'acknowledge', { name: 'acknowledge' }),
  once('announce', 'announce a clearance problem', { name: 'announce' }),
  once('mute', 'sounds off, on', { name: 'mute' }),
  once('plane', 'separating plane', { name: 'plane' }),
  once('bending', 'bending, exaggerated', { name: 'bending' }),
  once('otherMonitor', 'other monitor', { name: 'otherMonitor' }),
  once('cameraStep -', 'previous camera', { name: 'cameraStep', by: -1 }),
  once('cameraStep +', 'next camera', { name: 'cameraStep', by: 1 }),
  once('split', 'split', { name: 'split' }),
  once('matrix', 'all cameras', { name: 'matrix' }),
  once('offered pair', 'offered cameras', { name: 'offered pair' }),
  once('slow camera', 'slow cameras', { name: 'slow camera' }),
  once('light', 'light and lamps', { name: 'light' }),
  once('lock exposure', 'lock the exposure', { name: 'lock exposure' }),
  once('control page', 'PDRS control (SPEC 94)', { name: 'control page' }),
  once('leave', 'close sheets', { name: 'leave' }),
  ...Array.from({ length: CAMERAS }, (_, i) =>
    once(`camera ${i + 1}`, `camera ${i + 1}`, { name: 'camera', number: i + 1 }),
  ),
];

/** All functions by name, in the order of the sheet. */
export const USES: ReadonlyMap<string, Use> = new Map(
  [...axisUses(), ...ACTIONS].map((use) => [use.name, use]),
);

/** Returns the name of the function that deflects an axis to one side. */
export function axisUse(axis: number, sign: number): string {
  return `${sign < 0 ? '-' : '+'}${AXES[axis]}`;
}

/** Returns the name of a function on the page: `THC +X`, `rate hold`. */
export function labelOf(use: string): string {
  return USES.get(use)?.label ?? use;
}

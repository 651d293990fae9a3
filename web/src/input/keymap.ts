/**
 * Everything that a key, a button or an axis can be put to. To add one: a line in `USES`, its key in `defaults.ts`,
 * and for an action its case in `page/commands.ts`; sheet, saving, rebinding and recording follow from the table.
 */

import { AXES } from './deflection';

/** What is held for a while before it acts: close or open the hand, latch or unlatch what it holds, let go the brakes. */
export type Grip = 'close' | 'open' | 'latch' | 'brakes';

export type Action =
  | {
      readonly name:
        | 'stop'
        | 'rate'
        | 'rate hold'
        | 'safing'
        | 'position hold'
        | 'proceed'
        | 'enter'
        | 'otherMonitor'
        | 'split'
        | 'matrix'
        | 'acknowledge'
        | 'plane'
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
  /** When it went down or up [ms, as performance.now()]. */
  readonly at: number;
}

/** An axis held to one side, something done once a press, or a grip for as long as it is down. */
export type Does =
  | { readonly kind: 'axis'; readonly axis: number; readonly sign: 1 | -1 }
  | { readonly kind: 'once'; readonly action: Exclude<Action, GripAction> }
  | { readonly kind: 'grip'; readonly grip: Grip };

export interface Use {
  /** As a mapping writes it: `+X`, `rate hold`, `camera 3`. */
  readonly name: string;
  /** For people. */
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

/** Cameras that have a key each. */
const CAMERAS = 10;

const ACTIONS: readonly Use[] = [
  once('stop', 'stop', { name: 'stop' }),
  once('rate', 'coarse, vernier', { name: 'rate' }),
  once('rate hold', 'rate hold', { name: 'rate hold' }),
  held('close', 'capture, close'),
  held('open', 'release, open'),
  held('latch', 'latch, unlatch'),
  held('brakes', 'brakes'),
  once('safing', 'safing', { name: 'safing' }),
  once('position hold', 'position hold', { name: 'position hold' }),
  once('mode -', 'mode before', { name: 'turn mode', by: -1 }),
  once('mode +', 'mode after', { name: 'turn mode', by: 1 }),
  once('enter', 'enter mode', { name: 'enter' }),
  once('proceed', 'proceed', { name: 'proceed' }),
  once('joint -', 'joint before', { name: 'turn joint', by: -1 }),
  once('joint +', 'joint after', { name: 'turn joint', by: 1 }),
  once('fly orbiter', 'THC flies orbiter', { name: 'fly orbiter' }),
  once('acknowledge', 'acknowledge', { name: 'acknowledge' }),
  once('plane', 'separating plane', { name: 'plane' }),
  once('otherMonitor', 'other monitor', { name: 'otherMonitor' }),
  once('cameraStep -', 'camera before', { name: 'cameraStep', by: -1 }),
  once('cameraStep +', 'camera after', { name: 'cameraStep', by: 1 }),
  once('split', 'split', { name: 'split' }),
  once('matrix', 'all cameras', { name: 'matrix' }),
  once('slow camera', 'cameras turn slowly', { name: 'slow camera' }),
  once('light', 'light and lamps', { name: 'light' }),
  once('lock exposure', 'lock the exposure', { name: 'lock exposure' }),
  once('control page', 'PDRS control (SPEC 94)', { name: 'control page' }),
  once('leave', 'close what is open', { name: 'leave' }),
  ...Array.from({ length: CAMERAS }, (_, i) =>
    once(`camera ${i + 1}`, `camera ${i + 1}`, { name: 'camera', number: i + 1 }),
  ),
];

/** By name, in the order of the key sheet. */
export const USES: ReadonlyMap<string, Use> = new Map(
  [...axisUses(), ...ACTIONS].map((use) => [use.name, use]),
);

/** The use of an axis to one side. */
export function axisUse(axis: number, sign: number): string {
  return `${sign < 0 ? '-' : '+'}${AXES[axis]}`;
}

/** For people: `THC +X`, `rate hold`. */
export function labelOf(use: string): string {
  return USES.get(use)?.label ?? use;
}

/** Every lamp of the spine: its row, the log lines that belong to it, and the desk's group that shows its cause. */

import type { FlightLamp, Lamp } from '../../link/protocol';

/** Lamps of the simulation; lamps of this page's state; lamps that only TEST lights, because nothing simulates them. */
export type LampName =
  | FlightLamp
  | 'CHECK CRT'
  | 'CONTROLLER'
  | 'CAMERA'
  | 'LINK DELAY'
  | 'MCIU'
  | 'ABE'
  | 'GPC DATA'
  | 'PORT TEMP'
  | 'STBD TEMP';

export interface SpineLamp extends Omit<Lamp, 'name' | 'standing'> {
  readonly name: LampName;
  /** Whether the lamp has been lit since the run began, so that it raises no alarm. */
  readonly standing?: boolean;
}

export interface Concern {
  /** Kinds of log lines. */
  readonly kinds: readonly string[];
  /** Selectors of the elements that the lamp concerns, and of the group to outline if there are no such elements. */
  readonly elements: string;
  readonly group: string;
}

/** Lamps of `arm` and `station` show their cause beside them, lamps of `pair` in their tooltip. */
export type Row = 'arm' | 'pair' | 'station';

const EFFECTOR = ['captured', 'missed', 'rigid', 'released'];
const NONE: Concern = {
  kinds: ['refused', 'blocked', 'fault', 'page'],
  elements: '.events',
  group: '.events',
};

/** In display order. The compiler rejects a lamp without an entry. */
export const LAMPS: Readonly<Record<LampName, Concern & { readonly row: Row }>> = {
  SINGULAR: { row: 'arm', kinds: ['singular'], elements: '.distance.caution', group: '.singularity' },
  'REACH LIM': { row: 'arm', kinds: ['limit'], elements: '.joints tr.reach', group: '.joints' },
  'SOFT STOP': { row: 'arm', kinds: ['limit'], elements: '.joints tr.soft', group: '.joints' },
  'RATE LIM': { row: 'arm', kinds: [], elements: '.joints tr.limited', group: '.limits' },
  'CHECK CRT': { row: 'arm', ...NONE },
  MCIU: { row: 'pair', ...NONE },
  ABE: { row: 'pair', ...NONE },
  'GPC DATA': { row: 'pair', ...NONE },
  'CONTR ERR': { row: 'pair', kinds: [], elements: '.joints tr.overdriven', group: '.joints' },
  'PORT TEMP': { row: 'pair', ...NONE },
  'STBD TEMP': { row: 'pair', ...NONE },
  DERIGIDIZE: { row: 'pair', kinds: EFFECTOR, elements: '.flags', group: '.effector' },
  RELEASE: { row: 'pair', kinds: EFFECTOR, elements: '.flags', group: '.effector' },
  CAMERA: { row: 'pair', kinds: ['camera'], elements: '.monitor', group: '.events' },
  'TIME LOST': { row: 'pair', kinds: ['time lost'], elements: '.events', group: '.events' },
  'LINK DELAY': { row: 'pair', kinds: [], elements: '.rail .delay:not(.absent)', group: '.events' },
  CLEARANCE: {
    row: 'station',
    kinds: ['clearance', 'contact', 'inhibit'],
    elements: '.clearance .lit',
    group: '.clearance',
  },
  CONTROLLER: {
    row: 'station',
    kinds: ['controller', 'hands off', 'position hold'],
    elements: '.standing .device',
    group: '.rhc',
  },
};

/** Returns the lamps of a row, in display order. */
export function lampsIn(row: Row): readonly LampName[] {
  return (Object.keys(LAMPS) as LampName[]).filter((name) => LAMPS[name].row === row);
}

/** What each lamp speaks of: its lines in the log, and its place on the desk. */

export interface Concern {
  /** Kinds of log lines. */
  readonly kinds: readonly string[];
  /** The elements concerned now, and the group where there are none. */
  readonly elements: string;
  readonly group: string;
}

const OUTLINE_MS = 2000;
const EFFECTOR = ['captured', 'missed', 'rigid', 'released'];
const CONCERNS: Readonly<Record<string, Concern>> = {
  SINGULAR: { kinds: ['singular'], elements: '.distance.caution', group: '.singularity' },
  'REACH LIM': { kinds: ['limit'], elements: '.joints tr.reach', group: '.joints' },
  'SOFT STOP': { kinds: ['limit'], elements: '.joints tr.soft', group: '.joints' },
  'RATE LIM': { kinds: [], elements: '.joints tr.limited', group: '.limits' },
  DERIGIDIZE: { kinds: EFFECTOR, elements: '.flags', group: '.effector' },
  RELEASE: { kinds: EFFECTOR, elements: '.flags', group: '.effector' },
  'LINK DELAY': { kinds: [], elements: '.rail .delay:not(.absent)', group: '.events' },
  CAMERA: { kinds: [], elements: '.monitor', group: '.events' },
  CLEARANCE: { kinds: ['clearance', 'contact', 'inhibit'], elements: '.clearance .lit', group: '.clearance' },
  CONTROLLER: {
    kinds: ['controller', 'hands off', 'position hold'],
    elements: '.standing .device',
    group: '.rhc',
  },
};
const REST: Concern = {
  kinds: ['refused', 'blocked', 'fault', 'page'],
  elements: '.events',
  group: '.events',
};

export function concernOf(lamp: string): Concern {
  return CONCERNS[lamp] ?? REST;
}

/** Outlines the elements concerned for 2 s. */
export function outline({ elements, group }: Concern): void {
  const found = [...document.querySelectorAll(elements)];
  for (const element of found.length > 0 ? found : document.querySelectorAll(`.group${group}`)) {
    element.classList.add('concerned');
    setTimeout(() => element.classList.remove('concerned'), OUTLINE_MS);
  }
}

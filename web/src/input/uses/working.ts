/** Functions of the end effector, the worksite and the panel, in the order of the key map. */

import { TELESCOPE } from './sticks';
import { type Equipment, held, once, type Row, view } from './use';

const hasProng = ({ work }: Equipment) => work.hand === 'prong';

export const WORKING: readonly Row[] = [
  {
    help: (of) => `held 0.3 s: ${hasProng(of) ? 'the prong closes' : 'capture'}`,
    group: 'effector',
    uses: [{ name: 'close', label: 'capture, close', keys: ['KeyG'], does: held('close') }],
  },
  {
    help: (of) => `held 1 s: ${hasProng(of) ? 'the prong opens' : 'release'}`,
    group: 'effector',
    uses: [{ name: 'open', label: 'release, open', keys: ['KeyR'], does: held('open') }],
  },
  { help: 'while the prong moves: either stops it', has: hasProng, caps: ['close', 'open'], uses: [] },
  {
    help: 'held 1 s: latch the payload in its berth, or unlatch',
    group: 'effector',
    uses: [{ name: 'latch', label: 'latch, unlatch', keys: ['KeyT'], does: held('latch') }],
  },
  {
    help: 'safing, position hold; again: off',
    uses: [
      {
        name: 'safing',
        label: 'safing',
        keys: ['Delete'],
        does: once((page) => page.send({ type: 'safing', on: !page.frame?.safing })),
      },
      {
        name: 'position hold',
        label: 'position hold',
        keys: ['Insert'],
        does: once((page) => page.send({ type: 'position_hold', on: !page.frame?.position_hold })),
      },
    ],
  },
  {
    help: 'separating plane in the pictures',
    uses: [
      {
        name: 'plane',
        label: 'separating plane',
        keys: ['KeyF'],
        does: view((page) => page.togglePlane()),
      },
    ],
  },
  {
    help: 'bending exaggerated in the pictures',
    has: ({ flexures }) => flexures.length > 0,
    group: 'joints',
    uses: [
      {
        name: 'bending',
        label: 'bending, exaggerated',
        keys: ['NumpadMultiply'],
        does: view((page) => page.toggleBending()),
      },
    ],
  },
  {
    help: 'acknowledge the master alarm; sounds off, on',
    uses: [
      {
        name: 'acknowledge',
        label: 'acknowledge',
        keys: ['KeyM'],
        does: once((page) => page.acknowledge()),
      },
      { name: 'mute', label: 'sounds off, on', keys: ['NumpadDivide'], does: once((page) => page.mute()) },
    ],
  },
  {
    help: 'announce a clearance problem: it is logged',
    uses: [
      {
        name: 'announce',
        label: 'announce a clearance problem',
        keys: ['NumpadSubtract'],
        does: once((page) => page.send({ type: 'announce' })),
      },
    ],
  },
  {
    help: 'PDRS control: target, stored points, payloads',
    uses: [
      {
        name: 'control page',
        label: 'PDRS control (SPEC 94)',
        keys: ['Backslash'],
        does: once(({ controlPage }) => controlPage.toggle()),
      },
    ],
  },
  {
    help: 'console: print values, change them in flight',
    uses: [
      {
        name: 'console',
        label: 'console',
        keys: ['Numpad0'],
        does: once((page) => page.console.toggle()),
      },
    ],
  },
  TELESCOPE,
  {
    help: 'assign the THC to the orbiter, or to the arm',
    uses: [
      {
        name: 'fly orbiter',
        label: 'THC to orbiter',
        keys: ['Backquote'],
        does: once((page) => page.swapOrbiter()),
      },
    ],
  },
];

/** Esc, which the key map does not list: it closes the key map, too. */
export const LEAVE: Row = {
  help: 'close sheets',
  uses: [
    {
      name: 'leave',
      label: 'close sheets',
      keys: ['Escape'],
      fixed: 'Esc always closes sheets',
      does: once((page) => page.leave()),
    },
  ],
};

/** Functions of the arm and of the cameras, in the order of the key map. */

import type { Use as UseName } from '../../link/protocol';
import { LENS } from './sticks';
import { held, once, type Row, view } from './use';

const ENTERS = 'Enter presses buttons and enters the mode';

/** Number of cameras that have a key. */
const CAMERAS = 10;

export const FLYING: readonly Row[] = [
  {
    help: 'stop: centre the sticks, stop a sequence',
    uses: [
      {
        name: 'stop',
        label: 'stop',
        keys: ['Space'],
        fixed: 'Space always stops',
        does: once((page) => page.stop()),
      },
    ],
  },
  {
    help: 'brakes on; held 0.5 s: off',
    uses: [{ name: 'brakes', label: 'brakes', keys: ['KeyB'], does: held('brakes') }],
  },
  {
    help: 'coarse or vernier; rate hold, or cancel',
    uses: [
      {
        name: 'rate',
        label: 'coarse, vernier',
        keys: ['KeyV'],
        does: once((page) =>
          page.send({ type: 'select_rate', rate: page.frame?.rate === 'coarse' ? 'vernier' : 'coarse' }),
        ),
      },
      {
        name: 'rate hold',
        label: 'rate hold',
        keys: ['KeyH'],
        does: once((page) => page.send({ type: 'rate_hold' })),
      },
    ],
  },
  {
    help: 'held, or a button: each push moves 0.1 in, 0.1°',
    uses: [
      {
        name: 'pulse',
        label: 'pulse',
        keys: ['ShiftLeft'],
        does: { kind: 'pulse', act: (page) => page.togglePulse() },
      },
    ],
  },
  {
    help: 'turn the mode rotary, enter the mode',
    uses: [
      {
        name: 'mode -',
        label: 'previous mode',
        keys: ['BracketLeft'],
        does: once(({ groups }) => groups.mode.turn(-1)),
      },
      {
        name: 'mode +',
        label: 'next mode',
        keys: ['BracketRight'],
        does: once(({ groups }) => groups.mode.turn(1)),
      },
      {
        name: 'enter',
        label: 'enter mode',
        keys: ['Enter', 'NumpadEnter'],
        fixed: ENTERS,
        does: once((page) => page.enterMode()),
      },
    ],
  },
  {
    help: 'joint in SINGLE, DIRECT; THC X drives it',
    group: 'joints',
    uses: [
      {
        name: 'joint -',
        label: 'previous joint',
        keys: ['Minus'],
        does: once(({ groups }) => groups.mode.turnJoint(-1)),
      },
      {
        name: 'joint +',
        label: 'next joint',
        keys: ['Equal'],
        does: once(({ groups }) => groups.mode.turnJoint(1)),
      },
    ],
  },
  {
    help: 'proceed: start, or continue after a pause',
    uses: [
      {
        name: 'proceed',
        label: 'proceed',
        keys: ['KeyP'],
        does: once(({ groups }) => groups.target.proceed()),
      },
    ],
  },
  {
    help: 'select the other monitor, or half',
    uses: [
      {
        name: 'otherMonitor',
        label: 'other monitor',
        keys: ['KeyX'],
        does: once(({ pictures }) => pictures.monitors.takeOther()),
      },
    ],
  },
  {
    help: 'camera 1 to 10; twice: camera 11 to 20',
    range: true,
    uses: Array.from({ length: CAMERAS }, (_, i) => ({
      name: `camera ${i + 1}` as UseName,
      label: `camera ${i + 1}`,
      keys: [`Digit${(i + 1) % 10}`],
      does: view(({ pictures }) => pictures.monitors.chooseDigit(i, performance.now())),
    })),
  },
  {
    help: 'previous, next camera; offered pair',
    uses: [
      {
        name: 'cameraStep -',
        label: 'previous camera',
        keys: ['Comma'],
        does: view(({ pictures }) => pictures.monitors.step(-1)),
      },
      {
        name: 'cameraStep +',
        label: 'next camera',
        keys: ['Period'],
        does: view(({ pictures }) => pictures.monitors.step(1)),
      },
      {
        name: 'offered pair',
        label: 'offered cameras',
        keys: ['NumpadAdd'],
        does: once(({ pictures }) => pictures.offers.take()),
      },
    ],
  },
  LENS,
  {
    help: 'cameras turn slowly',
    uses: [
      {
        name: 'slow camera',
        label: 'slow cameras',
        keys: ['Semicolon'],
        does: once(({ pictures }) => pictures.monitors.toggleSlow()),
      },
    ],
  },
  {
    help: 'all cameras, and back; split',
    uses: [
      {
        name: 'matrix',
        label: 'all cameras',
        keys: ['KeyC'],
        does: once(({ pictures }) => pictures.toggleMatrix()),
      },
      {
        name: 'split',
        label: 'split',
        keys: ['KeyZ'],
        does: view(({ pictures }) => pictures.monitors.toggleSplit()),
      },
    ],
  },
  {
    help: 'sun and lamps; lock the exposure',
    uses: [
      {
        name: 'light',
        label: 'light and lamps',
        keys: ['Home'],
        does: once(({ light }) => light.toggle()),
      },
      {
        name: 'lock exposure',
        label: 'lock the exposure',
        keys: ['End'],
        does: once(({ light }) => light.lock()),
      },
    ],
  },
];

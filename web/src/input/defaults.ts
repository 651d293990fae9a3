/** Default mappings of all kinds of device. Those of the keyboard are in the tables of functions (`uses/`). */

import type { Use } from '../link/protocol';
import { KEYBOARD } from './keymap';
import type { Kind, Mapping } from './mapping';

type Bindings = Readonly<Record<string, Use>>;

const DEADBAND = 0.08;
const EXPO = 0.3;

/** Functions of a pad's cross (D-pad), pressed sticks, and buttons View and Menu, in the browser's standard mapping. */
const PAD_CAMERAS: Bindings = {
  b15: '+pan',
  b14: '-pan',
  b12: '+tilt',
  b13: '-tilt',
  b11: '+zoom',
  b10: '-zoom',
  b8: 'otherMonitor',
  b9: 'cameraStep +',
};

/** Functions of the panel, on the buttons of a pad while View is held. */
const PAD_PANEL: Bindings = {
  'b8+b14': 'mode -',
  'b8+b15': 'mode +',
  'b8+b0': 'enter',
  'b8+b3': 'proceed',
  'b8+b2': 'brakes',
};

/** Axes are positive to the right and towards the operator. A stick pushed away commands +X or nose up. */
const PAD: Bindings = {
  a1: '-X',
  a0: '+Y',
  b7: '+Z',
  b6: '-Z',
  a3: '-pitch',
  a2: '+yaw',
  b5: '+roll',
  b4: '-roll',
  'b9+b12': '+telescope',
  'b9+b13': '-telescope',
  b0: 'rate',
  b1: 'stop',
  b2: 'rate hold',
  b3: 'close',
  'b9+b3': 'open',
  'b9+b0': 'latch',
  'b9+b2': 'plane',
  'b9+b4': 'pulse',
  'b9+b8': 'fly orbiter',
  ...PAD_CAMERAS,
  ...PAD_PANEL,
};

const THC_PAD: Bindings = {
  a1: '-X',
  a0: '+Y',
  a3: '+Z',
  b7: '+Z',
  b6: '-Z',
  b0: 'pulse',
  b1: 'stop',
  'b9+b12': '+telescope',
  'b9+b13': '-telescope',
  'b9+b8': 'fly orbiter',
  ...PAD_CAMERAS,
  ...PAD_PANEL,
};

const RHC_PAD: Bindings = {
  a1: '-pitch',
  a0: '+roll',
  a2: '+yaw',
  b7: 'close',
  b6: 'open',
  b0: 'rate hold',
  b5: 'rate',
  b1: 'stop',
  b3: 'latch',
  b4: 'pulse',
  ...PAD_CAMERAS,
  ...PAD_PANEL,
};

/** Joysticks have no standard mapping. Most begin with the axes x, y, twist and the buttons trigger, thumb, pinkie. */
const THC_JOYSTICK: Bindings = { a1: '-X', a0: '+Y', a2: '+Z', b0: 'pulse', b1: 'stop' };
const RHC_JOYSTICK: Bindings = {
  a1: '-pitch',
  a0: '+roll',
  a2: '+yaw',
  b0: 'close',
  b1: 'rate hold',
  b2: 'rate',
  b3: 'pulse',
};

/** Axes: x to the right, y to the operator, z down, and right-handed rotations about them (HID Usage Tables, 4.2). */
const SPACEMOUSE: Bindings = {
  a1: '-X',
  a0: '+Y',
  a2: '+Z',
  a4: '-roll',
  a3: '+pitch',
  a5: '+yaw',
  b0: 'stop',
  b1: 'rate',
  b2: 'pulse',
};

/** Touch sticks: left stick and slider, right stick and slider. Their axes are positive to the right and downwards. */
const TOUCH: Bindings = { a1: '-X', a0: '+Y', a2: '+Z', a4: '-pitch', a3: '+yaw', a5: '+roll' };

function mapping(bindings: Bindings): Mapping {
  return { deadband: DEADBAND, expo: EXPO, bindings, centres: [] };
}

export const DEFAULTS: Readonly<Record<Kind, Mapping>> = {
  keyboard: { deadband: 0, expo: 0, bindings: KEYBOARD, centres: [] },
  pad: mapping(PAD),
  'thc pad': mapping(THC_PAD),
  'rhc pad': mapping(RHC_PAD),
  'thc joystick': mapping(THC_JOYSTICK),
  'rhc joystick': mapping(RHC_JOYSTICK),
  spacemouse: mapping(SPACEMOUSE),
  touch: mapping(TOUCH),
};

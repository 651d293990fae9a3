/**
 * The six steps of a first capture: their instructions, their controls, and how frames show that a step is complete.
 * In a text, `{+X}` stands for the control for +X on the device in use; `*…*` quotes a text on the desk.
 */

import type { Condition, Frame, Vec3 } from '../link/protocol';
import { conditionText } from '../words/condition-text';
import { small } from '../words/format';
import type { Units } from '../words/units';

/** Progress since the present step began. */
export interface Since {
  /** Position of the tip when the step began, panel components [m]. */
  readonly from: Vec3;
  /** Whether the operator has changed a picture or selected the other monitor. */
  readonly looked: boolean;
  /** Height of the payload above its berth [m]. */
  readonly lifted: number;
}

export interface Step {
  readonly name: string;
  readonly title: string;
  /** Instruction for the present state. */
  words(now: Frame, units: Units): string;
  /** Functions that the present state needs, and their effects. */
  caps(now: Frame): readonly Cap[];
  /** Groups of the desk that the step needs. */
  readonly groups: readonly ('thc' | 'conditions' | 'effector')[];
  done(now: Frame, since: Since): boolean;
}

export type Cap = readonly [use: string, does: string];

/** Least distance for which the tip counts as moved [m]. */
export const MOVED = 0.3;
/** Least height above its berth for which the payload counts as lifted [m]. */
export const LIFTED = 1;
/** Greatest `pin off axis` with which the end effector counts as aligned, as a fraction of that condition's limit. */
export const MIDDLE = 0.5;

/** Key caps of the THC, in the order of their positions on the keyboard. */
const MOVERS: readonly Cap[] = [
  ['-Z', 'up'],
  ['+X', 'closer'],
  ['+Z', 'down'],
  ['-Y', 'left'],
  ['-X', 'back'],
  ['+Y', 'right'],
];

export const STEPS: readonly Step[] = [
  {
    name: 'look',
    title: 'Look around',
    words: () =>
      'Each monitor shows a camera. *WR*, the wrist camera, looks along the end effector, at the pin to capture. ' +
      'Put another camera on the selected monitor: press {cameraStep +} or click a name under a picture.',
    caps: () => [
      ['cameraStep +', 'next camera'],
      ['otherMonitor', 'other monitor'],
    ],
    groups: [],
    done: (_, { looked }) => looked,
  },
  {
    name: 'move',
    title: 'Move the arm',
    words: () =>
      '{+X} moves the end effector in the viewing direction of *WR*; {-X} moves it back, the other keys ' +
      'move it sideways. Hold a key for some seconds and watch both pictures.',
    caps: () => MOVERS,
    groups: ['thc'],
    done: (now, { from }) => distance(now.display.actual.position, from) >= MOVED,
  },
  {
    name: 'line up',
    title: 'Line up with the pin',
    words: (now, units) => {
      const off = offAxis(now);
      const near = off ? `under ${small(MIDDLE * off.limit, units.gap)} ${units.gap.name}` : 'small';
      return (
        'Move sideways until the ball on the dark target is in the middle of *WR*. Release the stick once *pin off axis* below is ' +
        `${near}; *to pin* beside it shows the directions. {rate} changes to slow rates, and back.`
      );
    },
    caps: () => [
      ['-Z', 'up'],
      ['rate', 'slow, fast'],
      ['+Z', 'down'],
      ['-Y', 'left'],
      ['stop', 'stop'],
      ['+Y', 'right'],
    ],
    groups: ['thc', 'conditions'],
    done: (now) => held(now) || (centred(now) && now.translation.every((value) => value === 0)),
  },
  {
    name: 'close in',
    title: 'Close in',
    words: (now, units) =>
      lined(now)
        ? `Hold {+X} until *pin depth* has its tick too. Go slowly over the last ${units.name === 'SI' ? '30 cm' : 'foot'}: {rate}. ` +
          'Too far? {-X} moves back.'
        : `No longer aligned: ${wanting(now, units)}. Move sideways until every condition except *pin depth* has its tick.`,
    caps: () => MOVERS,
    groups: ['thc', 'conditions'],
    done: (now) => held(now) || met(now),
  },
  {
    name: 'capture',
    title: 'Capture it',
    words: (now, units) => {
      if (now.work.hand.flags.includes('CLOSE'))
        return 'The snares have closed without the pin. Hold {open} for a second to open them, then try again.';
      if (now.work.hand.switch === 'close') return 'The snares are closing on the pin.';
      if (!met(now)) return `Not yet: ${wanting(now, units)}. Move until every condition has its tick.`;
      return 'The pin is between the snares. Hold {close} until its bar is full: the snares close on the pin.';
    },
    caps: () => [
      ['close', 'capture'],
      ['open', 'release'],
    ],
    groups: ['thc', 'effector', 'conditions'],
    done: (now) => held(now),
  },
  {
    name: 'lift',
    title: 'Lift it out',
    words: (now, units) => {
      if (!held(now)) return 'The payload is no longer captured. Go back, and capture it again.';
      if (!now.work.hand.flags.includes('RIGID'))
        return 'The pin is captured, and the end effector rigidizes: wait for *RIGID*.';
      if (!isFree(now))
        return 'Latches still hold the payload. Hold {latch} for a second: the latches open, which takes half a minute.';
      const high = units.name === 'SI' ? '1 m' : '40 in';
      const fast = now.rate === 'vernier' ? ' {rate} changes to fast rates.' : '';
      return (
        'The payload is free. Hold {-X}: the end effector moves back and lifts the payload. Stop when it is ' +
        `${high} above its berth.${fast}${besides(now)}`
      );
    },
    caps: (now) =>
      isFree(now)
        ? [
            ['-X', 'back, up'],
            ['rate', 'slow, fast'],
          ]
        : [['latch', 'unlatch']],
    groups: ['thc', 'effector'],
    done: (now, { lifted }) => held(now) && lifted >= LIFTED,
  },
];

export function held({ work }: Frame): boolean {
  return work.cargo.some((cargo) => cargo.held);
}

/** Returns whether the payload is captured and unlatched. */
export function isFree(now: Frame): boolean {
  return held(now) && !now.work.cargo.some((cargo) => cargo.held && cargo.seat !== '');
}

/** Returns whether all conditions hold; the distance to the pin is ignored. */
function lined({ work: { conditions } }: Frame): boolean {
  return conditions.length > 0 && conditions.every(({ name, holds }) => holds || name === 'pin depth');
}

function met({ work: { conditions } }: Frame): boolean {
  return conditions.length > 0 && conditions.every(({ holds }) => holds);
}

/** Returns whether the end effector is aligned, with a margin for drift during the approach to the pin. */
function centred(now: Frame): boolean {
  const off = offAxis(now);
  return lined(now) && off !== undefined && off.value <= MIDDLE * off.limit;
}

function offAxis({ work: { conditions } }: Frame): Condition | undefined {
  return conditions.find(({ name }) => name === 'pin off axis');
}

/** Returns an explanation of what the desk displays near the berth, if it could mislead a beginner; else empty. */
function besides(now: Frame): string {
  return now.work.clearance_level === 'warning'
    ? ' *CLEARANCE* warns because the berth is close: press *MASTER ALARM* and continue.'
    : '';
}

/** Returns the text of a condition that prevents a capture, as the panel displays it. */
function wanting({ work: { conditions } }: Frame, units: Units): string {
  const fails = ({ holds, name }: Condition) => !holds && name !== 'pin depth';
  const first = conditions.find(fails) ?? conditions.find(({ holds }) => !holds);
  return first ? conditionText(first, units) : 'no pin is near';
}

function distance([ax, ay, az]: Vec3, [bx, by, bz]: Vec3): number {
  return Math.hypot(ax - bx, ay - by, az - bz);
}

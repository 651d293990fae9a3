/**
 * The six steps of a first capture: what each asks for, what it is flown with, and by what the frames show that it is
 * done. `{+X}` in words stands for whatever moves +X on the device in use; `*…*` is something that the desk shows.
 */

import type { Condition, Frame, Vec3 } from '../link/protocol';
import { conditionText } from '../words/condition-text';
import { small } from '../words/format';
import type { Units } from '../words/units';

/** What is known of the flight since a step began. */
export interface Since {
  /** Where the tip was, panel components [m]. */
  readonly from: Vec3;
  /** The operator has changed a picture, or taken the other monitor in hand. */
  readonly looked: boolean;
  /** How far the payload has come up out of its seat [m]. */
  readonly lifted: number;
}

export interface Step {
  readonly name: string;
  readonly title: string;
  /** Instruction for the present state. */
  words(now: Frame, units: Units): string;
  /** Uses that matter now, and what each does here. */
  caps(now: Frame): readonly Cap[];
  /** The desk's groups concerned. */
  readonly groups: readonly ('thc' | 'conditions' | 'effector')[];
  done(now: Frame, since: Since): boolean;
}

export type Cap = readonly [use: string, does: string];

/** The tip has moved when it has come this far [m]. */
export const MOVED = 0.3;
/** Height above its seat from which on the payload counts as lifted [m]. */
export const LIFTED = 1;
/** Lined up means as near to the axis as this part of what capture allows. */
export const MIDDLE = 0.5;

/** By place on the keyboard, as the left hand has them. */
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
      'Each monitor shows a camera. *WR*, the wrist camera, looks along the end effector, at the pin that it shall take. ' +
      'Put another camera on the monitor in hand: press {cameraStep +} or click one under a picture.',
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
      'The end effector goes where its own camera looks: {+X} into the picture of *WR*, {-X} back out of it, the others ' +
      'across it. Hold one for some seconds and watch both pictures.',
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
        'Slide until the ball on the dark target stands in the middle of *WR*, and let go once *pin off axis* below is ' +
        `${near}; *to pin* beside it tells the way. {rate} changes to slow rates, and back.`
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
          'Too far? {-X} takes you back.'
        : `Off the line again: ${wanting(now, units)}. Slide back until every condition but *pin depth* has its tick.`,
    caps: () => MOVERS,
    groups: ['thc', 'conditions'],
    done: (now) => held(now) || met(now),
  },
  {
    name: 'capture',
    title: 'Capture it',
    words: (now, units) => {
      if (now.work.hand.flags.includes('CLOSE'))
        return 'The snares have closed on nothing. Hold {open} for a second to open them, then try again.';
      if (now.work.hand.switch === 'close') return 'The snares close round the pin.';
      if (!met(now))
        return `Not yet: ${wanting(now, units)}. Bring it back until every condition has its tick.`;
      return 'The pin stands between the snares. Hold {close} until its bar is full: they close round it.';
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
      if (!held(now)) return 'The payload is no longer held. Go back, and capture it once more.';
      if (!now.work.hand.flags.includes('RIGID'))
        return 'You have it. The end effector draws the pin in and pulls tight: wait for *RIGID*.';
      if (!isFree(now))
        return 'Latches still hold the payload. Hold {latch} for a second: they let go, which takes half a minute.';
      const high = units.name === 'SI' ? '1 m' : '40 in';
      const fast = now.rate === 'vernier' ? ' {rate} changes to fast rates.' : '';
      return (
        'Free. Hold {-X}: the end effector backs up, and the payload comes with it, until it stands ' +
        `${high} above its seat.${fast}${besides(now)}`
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

/** The payload is held and out of its latches. */
export function isFree(now: Frame): boolean {
  return held(now) && !now.work.cargo.some((cargo) => cargo.held && cargo.seat !== '');
}

/** Only the way to the pin is left. */
function lined({ work: { conditions } }: Frame): boolean {
  return conditions.length > 0 && conditions.every(({ name, holds }) => holds || name === 'pin depth');
}

function met({ work: { conditions } }: Frame): boolean {
  return conditions.length > 0 && conditions.every(({ holds }) => holds);
}

/** Lined up, and well within the bound: what drifts on the way in has room. */
function centred(now: Frame): boolean {
  const off = offAxis(now);
  return lined(now) && off !== undefined && off.value <= MIDDLE * off.limit;
}

function offAxis({ work: { conditions } }: Frame): Condition | undefined {
  return conditions.find(({ name }) => name === 'pin off axis');
}

/** What the desk shows of the seat just left, where that would mislead. */
function besides(now: Frame): string {
  if (now.work.clearance_level === 'warning')
    return ' *CLEARANCE* warns while the seat is so close: press *MASTER ALARM*, and lift on.';
  return met(now) ? ' The panel offers to latch it again: not now.' : '';
}

/** Condition that prevents a capture, as the panel displays it. */
function wanting({ work: { conditions } }: Frame, units: Units): string {
  const fails = ({ holds, name }: Condition) => !holds && name !== 'pin depth';
  const first = conditions.find(fails) ?? conditions.find(({ holds }) => !holds);
  return first ? conditionText(first, units) : 'no pin is near';
}

function distance([ax, ay, az]: Vec3, [bx, by, bz]: Vec3): number {
  return Math.hypot(ax - bx, ay - by, az - bz);
}

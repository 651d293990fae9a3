/**
 * The six steps of a first capture: what each asks for, what it is flown with, and by what the frames show that it is
 * done. `{+X}` in words stands for whatever moves +X on the device in use; `*…*` is something that the desk shows.
 */

import type { Condition, Frame, Vec3 } from '../protocol';

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
  /** What to do, as the flight stands now. */
  words(now: Frame): string;
  /** Uses that matter, and what each does here. */
  readonly caps: readonly Cap[];
  /** The desk's groups concerned. */
  readonly groups: readonly ('thc' | 'conditions' | 'effector')[];
  done(now: Frame, since: Since): boolean;
}

export type Cap = readonly [use: string, does: string];

/** The tip has moved when it has come this far [m]. */
export const MOVED = 0.3;
/** The payload is lifted when it stands so high above its seat [m]. */
export const LIFTED = 1;

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
    caps: [
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
    caps: MOVERS,
    groups: ['thc'],
    done: (now, { from }) => distance(now.actual.position, from) >= MOVED,
  },
  {
    name: 'line up',
    title: 'Line up with the pin',
    words: () =>
      'Slide until the ball on the dark target stands in the middle of *WR*, and let go once *pin off axis* has its ' +
      'tick below. {rate} changes to slow rates, and back.',
    caps: [
      ['-Z', 'up'],
      ['rate', 'slow, fast'],
      ['+Z', 'down'],
      ['-Y', 'left'],
      ['stop', 'stop'],
      ['+Y', 'right'],
    ],
    groups: ['thc', 'conditions'],
    done: (now) => held(now) || (lined(now) && now.translation.every((value) => value === 0)),
  },
  {
    name: 'close in',
    title: 'Close in',
    words: (now) =>
      lined(now)
        ? 'Hold {+X} until *pin depth* has its tick too. Go slowly over the last foot: {rate}. Too far? {-X} takes you back.'
        : `Off the line again: ${wanting(now)}. Slide back until every condition but *pin depth* has its tick.`,
    caps: [
      ['+X', 'closer'],
      ['-X', 'back'],
      ['rate', 'slow, fast'],
    ],
    groups: ['thc', 'conditions'],
    done: (now) => held(now) || met(now),
  },
  {
    name: 'capture',
    title: 'Capture it',
    words: (now) => {
      if (now.work.hand.flags.includes('CLOSE'))
        return 'The snares have closed on nothing. Hold {open} for a second to open them, then try again.';
      if (now.work.hand.switch === 'close') return 'The snares close round the pin.';
      if (!met(now)) return `Not yet: ${wanting(now)}. Bring it back until every condition has its tick.`;
      return 'The pin stands between the snares. Hold {close} until its bar is full: they close round it.';
    },
    caps: [
      ['close', 'capture'],
      ['open', 'release'],
    ],
    groups: ['thc', 'effector', 'conditions'],
    done: (now) => held(now),
  },
  {
    name: 'lift',
    title: 'Lift it out',
    words: (now) => {
      if (!held(now)) return 'The payload is no longer held. Go back, and capture it once more.';
      if (!now.work.hand.flags.includes('RIGID'))
        return 'You have it. The end effector draws the pin in and pulls tight: wait for *RIGID*.';
      if (now.work.cargo.some((cargo) => cargo.held && cargo.seat !== ''))
        return 'Latches still hold the payload. Hold {latch} for a second: they let go, which takes half a minute.';
      return 'Free. Hold {-X}: the end effector backs up, and the payload comes with it. One metre will do.';
    },
    caps: [
      ['latch', 'unlatch'],
      ['-X', 'back, up'],
    ],
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

/** What stands against a capture, in the panel's own words. */
function wanting({ work: { conditions } }: Frame): string {
  const fails = ({ holds, name }: Condition) => !holds && name !== 'pin depth';
  const first = conditions.find(fails) ?? conditions.find(({ holds }) => !holds);
  return first?.text ?? 'no pin is near';
}

function distance([ax, ay, az]: Vec3, [bx, by, bz]: Vec3): number {
  return Math.hypot(ax - bx, ay - by, az - bz);
}

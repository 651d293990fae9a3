/** Look-ahead: numbers for the arm at the predicted pose, with the present stick command. The ghost shows this pose. */

import type { Ahead, JointInfo } from '../../link/protocol';
import { small } from '../../words/format';
import { motionText } from '../../words/joint';
import type { Units } from '../../words/units';
import { button, el, group, setAbout, setAttribute, setClass, setText } from '../parts/dom';
import type { Desk, Part } from '../parts/part';

/** Prediction times [s]. */
const TIMES = [2, 5, 10, 20] as const;

export function lookAhead(desk: Desk): Part {
  let seconds = 5;
  const time = button({ class: 'more', title: 'Change the prediction time' }, [], () =>
    desk.send({ type: 'look_ahead', seconds: next(seconds) }),
  );
  const [clear, stop, joint] = [el('b'), el('b'), el('b')];
  const element = group(
    'look-ahead',
    'Look ahead',
    el(
      'dl',
      {},
      el('dt', {}, el('span', {}, 'Clearance '), 'then'),
      el('dd', {}, clear),
      el('dt', {}, 'Stops within'),
      el('dd', {}, stop),
      el('dt', {}, el('span', {}, 'Nearest '), 'limit'),
      el('dd', {}, joint),
    ),
  );
  element.querySelector('h2')?.append(time);
  element.querySelector('h2 b')?.setAttribute('title', ABOUT);
  return {
    element,
    values({
      frame: {
        display: { ahead },
      },
      units,
    }) {
      setText(time, `${(ahead?.seconds ?? seconds).toFixed(0)} s`);
      if (!ahead) return;
      seconds = ahead.seconds;
      const prediction = words(ahead, desk.welcome.joints, units);
      setText(clear, prediction.clearance);
      setAttribute(clear, 'title', prediction.between);
      setText(stop, prediction.stopping);
      setText(joint, prediction.joint);
      setAbout(element, about(ahead));
      setClass(element, 'resting-sticks', !ahead.held);
      setClass(clear, 'caution', ahead.contact_s !== null || below(ahead, desk.welcome.work.caution));
      setClass(joint, 'caution', ahead.room <= 0);
    },
  };
}

const ABOUT =
  'Prediction with the present stick command. If the sticks are centred: with full deflection of the axis that was ' +
  'deflected last. The blue arm in the pictures is the predicted arm.';

/**
 * Returns a word for the stick command that the prediction uses: the present deflection, full deflection of the axis
 * that was deflected last, or centred sticks. The word is short enough for the heading.
 */
export function about({ held, moves }: Pick<Ahead, 'held' | 'moves'>): string {
  if (held) return 'deflected';
  return moves ? 'last axis' : 'centred';
}

/** Returns the prediction time that follows `seconds`; after the longest time, the shortest one follows [s]. */
export function next(seconds: number): number {
  return TIMES.find((each) => each > seconds) ?? TIMES[0];
}

function below({ clearance }: Ahead, caution: number): boolean {
  return clearance !== null && clearance < caution;
}

/** The numbers in the operator's units. */
export function words(
  ahead: Ahead,
  joints: readonly Pick<JointInfo, 'label' | 'slides'>[],
  units: Units,
): {
  readonly clearance: string;
  readonly between: string;
  readonly stopping: string;
  readonly joint: string;
} {
  const { clearance, a, b, contact_s, stopping, joint, room } = ahead;
  const { gap } = units;
  const shown = (value: number) => `${small(value, gap)} ${gap.name}`;
  const nearest = joints[joint];
  const left = nearest ? motionText(nearest, room, units, 0) : '';
  return {
    clearance:
      contact_s !== null ? `contact ${contact_s.toFixed(1)} s` : clearance === null ? '–' : shown(clearance),
    between: clearance === null ? '' : `${a} to ${b}`,
    stopping: shown(stopping),
    joint: `${nearest?.label ?? ''} ${room > 0 ? left : `${left} past`}`,
  };
}

/** AUTO 1-4: the next point, the remaining distance and time, and the effect of PROCEED and STOP. */

import type { Frame } from '../../link/protocol';
import { degrees, fixed } from '../../words/format';
import type { Units } from '../../words/units';
import { el, setText } from '../parts/dom';

export interface Route {
  readonly element: HTMLElement;
  set(frame: Frame, units: Units): void;
}

export function route(): Route {
  const point = el('p', { class: 'point' });
  const [distance, angle, time] = [el('dd'), el('dd'), el('dd')];
  const unit = el('i');
  const hint = el('p', { class: 'remaining' });
  const element = el(
    'div',
    { class: 'route' },
    point,
    el(
      'dl',
      {},
      el('dt', {}, 'Distance ', unit),
      distance,
      el('dt', {}, 'Angle ', el('i', {}, '°')),
      angle,
      el('dt', {}, 'Time to go ', el('i', {}, 's')),
      time,
    ),
    hint,
  );
  return {
    element,
    set(frame, { length }) {
      const { goal, points } = frame;
      setText(point, points > 0 ? `Point ${frame.point} of ${points}` : 'No points stored');
      setText(unit, length.name);
      setText(distance, goal ? fixed(goal.distance * length.perSi, length.decimals, false) : '–');
      setText(angle, goal ? degrees(goal.angle, 1, false) : '–');
      setText(time, frame.sequence === 'in progress' && goal ? String(Math.ceil(goal.remaining_s)) : '–');
      setText(hint, whatNext(frame));
    },
  };
}

/** Present effect of PROCEED and STOP, in a sentence. */
export function whatNext({ sequence, point, points, goal, check }: Frame): string {
  if (points === 0) return 'This position has no points.';
  if (sequence === 'in progress') return 'Moves to the next pause point; STOP or Space stops it.';
  if (check && !check.good) return 'Move clear, then enter the mode again.';
  if (point === 1) return 'PROCEED starts the sequence.';
  return goal ? 'Paused; PROCEED continues.' : 'Sequence complete; PROCEED repeats it.';
}

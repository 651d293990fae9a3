/** Targets of the automatic modes: the keyed-in pose of OPR CMD, or the stored points of AUTO 1-4. */

import type { Frame } from '../../link/protocol';
import { degrees, fixed } from '../../words/format';
import type { Units } from '../../words/units';
import { verdict } from '../desk/verdict';
import { el, group, setAbout, setText } from '../parts/dom';
import type { Desk, Part } from '../parts/part';
import { entry } from './entry';
import { route } from './route';

export interface TargetGroup extends Part {
  /** Sends PROCEED. If there are typed values, keys them in first, and sends nothing if one of them is invalid. */
  proceed(): void;
}

export function targetGroup(desk: Desk): TargetGroup {
  const keyed = entry(desk);
  const stored = route();
  const check = verdict();
  const togo = el('p', { class: 'remaining' });
  const element = group('target', 'Target', keyed.element, stored.element, check.element, togo);
  let byPoints = false;
  return {
    element,
    proceed() {
      if (!byPoints && keyed.edited() && !keyed.keyIn()) return;
      desk.send({ type: 'proceed' });
    },
    values({ frame, units }) {
      byPoints = frame.mode.startsWith('AUTO');
      keyed.element.hidden = byPoints;
      togo.hidden = byPoints;
      stored.element.hidden = !byPoints;
      if (byPoints) {
        stored.set(frame, units);
        setAbout(element, frame.mode);
      } else {
        keyed.set(frame, units);
        const none = keyed.follows() ? 'none; the present point' : 'none keyed in';
        setAbout(element, keyed.edited() ? 'not keyed in yet' : frame.goal ? 'keyed in' : none);
        setText(togo, remaining(frame, units));
      }
      check.set(frame);
    },
  };
}

export function remaining({ goal, sequence, mode }: Frame, { length }: Units): string {
  if (!goal) return 'OPR CMD moves the tip to the target.';
  const left = `${fixed(goal.distance * length.perSi, length.decimals, false)} ${length.name}, ${degrees(goal.angle, 1, false)}°`;
  if (sequence === 'in progress') return `${left} to go, ${Math.ceil(goal.remaining_s)} s`;
  return mode === 'OPR CMD' ? `${left} away` : `${left} away; OPR CMD moves there.`;
}

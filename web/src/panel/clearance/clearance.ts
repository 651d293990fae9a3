/** The minimum clearance: its parts, rate of change, and curve over the last minute. Also ARM and FINGER INHIBIT. */

import { type Display, type Near, READOUTS } from '../../link/protocol';
import { capitalised, small } from '../../words/format';
import type { Unit, Units } from '../../words/units';
import { button, el, group, setAttribute, setClass, setLit, setPressed, setText } from '../parts/dom';
import type { Desk, Part } from '../parts/part';
import { touching } from './contacts';
import { gapGauge } from './gap-gauge';
import { contactIn, STEADY } from './gap-scale';
import { lastMinute } from './minute';
import { Trend } from './trend';

export interface ClearanceGroup extends Part {
  /** Marks the button of the separating plane; `on`: whether the pictures show the plane. */
  setPlane(on: boolean): void;
}

export function clearanceGroup({ welcome, act }: Desk): ClearanceGroup {
  const { work } = welcome;
  const number = el('b', { class: 'gap-value' });
  const unit = el('span', { class: 'unit' });
  const closing = el('span');
  const contact = el('span');
  const pair = el('p', { class: 'pair' });
  const task = el('p', { class: 'pair task-pair' });
  const gauge = gapGauge(work);
  const history = lastMinute(work);
  const contacts = touching(welcome);
  const arm = el('span', { class: 'flag' }, 'Arm inhibit');
  const finger = el('span', { class: 'flag' }, 'Finger inhibit');
  const planeKey = button({ class: 'more', 'data-calm': 'plane' }, ['Plane'], () => act('plane'));
  const element = group(
    'clearance',
    READOUTS.clearance.title,
    el(
      'div',
      { class: 'reading' },
      el('p', { class: 'number' }, number, ' ', unit),
      el('p', { class: 'closing' }, closing, contact),
    ),
    pair,
    task,
    gauge.element,
    history.element,
    contacts.element,
    el('div', { class: 'inhibits', role: 'status', 'aria-label': 'Inhibited' }, arm, finger),
  );
  element.querySelector('h2')?.append(planeKey);
  const trend = new Trend();
  return {
    element,
    setPlane(on) {
      setPressed(planeKey, on);
    },
    bars({ frame }) {
      const { nearest } = frame.work;
      trend.add(frame.time_s, nearest?.clearance ?? null);
      gauge.point(nearest?.clearance ?? null);
    },
    values({ frame, units, controllers }) {
      const { nearest, clearance_level, arm_inhibit, finger_inhibit } = frame.work;
      setAttribute(
        planeKey,
        'title',
        `Show the plane that separates the two parts: ${controllers.names.name('plane')}`,
      );
      setClass(element, 'caution', clearance_level === 'caution');
      setClass(element, 'warning', clearance_level === 'warning');
      setText(number, nearest ? small(nearest.clearance, units.gap) : '–');
      setText(unit, nearest ? units.gap.name : '');
      setText(closing, nearest ? closingWords(nearest, units.creep) : '');
      setText(contact, nearest ? contactWords(nearest.clearance, nearest.closing) : '');
      setText(pair, nearest ? pairWords(nearest) : 'No pair is monitored');
      setAttribute(pair, 'title', pair.textContent);
      setText(task, taskPairWords(frame.display, nearest, units));
      setAttribute(task, 'title', task.textContent && TASK_PAIR);
      gauge.setUnits(units);
      // Contacts, and the task's pair, take the room of the curve of the last minute.
      history.element.hidden = contacts.set(frame, units, controllers.names) || task.textContent !== '';
      history.draw(trend, frame.time_s, units);
      setLit(arm, arm_inhibit);
      setLit(finger, finger_inhibit);
      finger.hidden = work.hand !== 'prong';
    },
  };
}

function pairWords({ a, b }: Pick<Near, 'a' | 'b'>): string {
  return `${capitalised(a)} to ${b}`;
}

const TASK_PAIR =
  'The parts that this step of the task brings together; they light no lamp while the approach goes well';

/**
 * Returns the clearance of the pair that the task brings together, and the time to their contact at the present speed;
 * empty if this pair is shown already, or none is.
 */
export function taskPairWords(
  { task_pair: task }: Pick<Display, 'task_pair'>,
  nearest: Pick<Near, 'a' | 'b'> | null,
  { gap }: Pick<Units, 'gap'>,
): string {
  if (!task || (nearest && task.a === nearest.a && task.b === nearest.b)) return '';
  const contact = contactWords(task.clearance, task.closing);
  const parts = `${task.a} to ${task.b}`;
  return `Task: ${small(task.clearance, gap)} ${gap.name}, ${contact ? `${contact}, ` : ''}${parts}`;
}

/** `contact in 3 s`; empty if no contact is near. */
function contactWords(clearance: number, closing: number): string {
  const seconds = contactIn(clearance, closing);
  return seconds === null ? '' : `contact in ${Math.max(1, Math.round(seconds))} s`;
}

function closingWords({ closing, clearance }: Near, creep: Unit): string {
  if (clearance <= 0) return 'in contact';
  if (Math.abs(closing) < STEADY) return 'steady';
  return `${closing > 0 ? 'closing' : 'opening'} ${small(Math.abs(closing), creep)} ${creep.name}`;
}

/** Returns the text beside the lamp CLEARANCE: the pair and its clearance. */
export function clearanceCause(nearest: Near, { gap }: Units): string {
  return `${small(nearest.clearance, gap)} ${gap.name}, ${nearest.a} to ${nearest.b}`;
}

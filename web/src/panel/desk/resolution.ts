/** Point of resolution: position, attitude and rates, commanded and actual. */

import type { Frame, JointInfo, ModeInfo, Resolution } from '../../link/protocol';
import { attitude, degrees, fixed } from '../../words/format';
import { rateBar } from '../parts/bar';
import { el, group, setAbout, setAttribute, setClass, setText } from '../parts/dom';
import type { Desk, Part } from '../parts/part';

/** Steering law 7, which translates along the orbiter's axes and rotates about the payload's axes. */
const IN_PAYLOAD_AXES = 7;
const ROWS = ['X', 'Y', 'Z', 'Pitch', 'Yaw', 'Roll'] as const;

export function resolution(desk: Desk): Part {
  const rows = ROWS.map((name) => {
    const [unit, rateUnit] = [el('i'), el('i', { 'data-calm': 'full' })];
    const cells = {
      actual: el('td', { class: 'actual' }),
      commanded: el('td', { class: 'commanded', 'data-calm': 'full' }),
      rate: el('td', { class: 'rate', 'data-calm': 'full' }),
      tag: el('span', { class: 'limit-tag' }),
      unit,
      rateUnit,
      bar: rateBar(),
    };
    const row = el(
      'tr',
      {},
      el('th', { scope: 'row' }, name, ' ', unit, rateUnit),
      cells.actual,
      cells.commanded,
      cells.rate,
      el('td', { class: 'of-limit', 'data-calm': 'full' }, el('div', {}, cells.bar.element, cells.tag)),
    );
    return { ...cells, row };
  });
  const element = group(
    'resolution',
    'Point of resolution',
    el(
      'table',
      {},
      el(
        'thead',
        {},
        el(
          'tr',
          {},
          el('td'),
          el('th', { scope: 'col' }, 'actual'),
          ...['commanded', 'rate /s', 'of limit'].map((name) =>
            el('th', { scope: 'col', 'data-calm': 'full' }, name),
          ),
        ),
      ),
      el('tbody', {}, ...rows.map(({ row }) => row)),
    ),
  );
  return {
    element,
    bars({ frame }) {
      const actual = parts(frame.display.actual);
      const commanded = parts(frame.display.commanded);
      rows.forEach(({ bar }, i) => {
        const limit = frame.por_limits[i < 3 ? 0 : 1] || 1;
        bar.set((actual[i] ?? 0) / limit, (commanded[i] ?? 0) / limit);
      });
    },
    values({ frame, units }) {
      const mode = desk.welcome.modes.find((each) => each.position === frame.mode);
      setClass(element, 'single', mode?.kind === 'single');
      setAbout(element, pointWords(mode, frame, desk.welcome.joints));
      const rates = parts(frame.display.actual);
      const tags = limitTags(frame, desk.welcome.joints);
      rows.forEach((cells, i) => {
        const turn = i >= 3;
        const axis = i % 3;
        const at = (turn ? frame.display.actual.attitude : frame.display.actual.position)[axis] ?? 0;
        const goal = (turn ? frame.display.commanded.attitude : frame.display.commanded.position)[axis] ?? 0;
        const { length, speed } = units;
        const show = (value: number) =>
          turn ? attitude(value) : fixed(value * length.perSi, length.decimals);
        setText(cells.unit, turn ? '°' : length.name);
        setText(cells.rateUnit, turn ? ', °/s' : `, ${speed.name}`);
        setText(cells.actual, show(at));
        setText(cells.commanded, show(goal));
        const rate = rates[i] ?? 0;
        setText(cells.rate, turn ? degrees(rate, 2) : fixed(rate * speed.perSi, speed.decimals));
        const tag = tags[i];
        setText(cells.tag, tag?.text ?? '');
        setClass(cells.tag, 'own', tag?.caution === false);
        setClass(cells.row, 'limited', tag?.caution === true);
        setAttribute(cells.row, 'data-axis', String(i));
      });
    },
  };
}

function parts(point: Resolution): readonly number[] {
  return [...point.velocity, ...point.turn_rate];
}

/** Names the point that moves, and the axes of its motion. */
export function pointWords(mode: ModeInfo | undefined, frame: Frame, joints: readonly JointInfo[]): string {
  switch (mode?.kind) {
    case 'single':
      return `tip; ${joints[frame.joint]?.label.toLowerCase() ?? 'one joint'} moves`;
    case 'automatic':
    case 'manual': {
      return frame.law === IN_PAYLOAD_AXES
        ? `${mode.point}; turns in payload axes`
        : `${mode.point}, ${mode.axes}`;
    }
    case 'master':
      return 'tip; the joints follow the master';
    default:
      return 'tip';
  }
}

interface Tag {
  readonly text: string;
  /** Whether the limit is a caution. The POR's limits are active in every motion, so they are not cautions. */
  readonly caution: boolean;
}

/** Returns for each row the active limit to display there. A limit is displayed at the axis that it affects most. */
export function limitTags(frame: Frame, joints: readonly JointInfo[]): readonly (Tag | null)[] {
  const tags: (Tag | null)[] = [null, null, null, null, null, null];
  const commanded = parts(frame.display.commanded);
  const behind = parts(frame.display.actual).map((rate, i) => rate - (commanded[i] ?? 0));
  const [speed, turn] = frame.por_limits;
  const moving = Math.hypot(...commanded.slice(0, 3)) > 1e-4 ? 0 : 3;
  const put = (row: number, text: string, caution: boolean) => {
    if (caution || !tags[row]) tags[row] = { text, caution };
  };
  for (const limit of frame.limits) {
    switch (limit.kind) {
      case 'POR translation':
        put(largest(commanded, 0), 'POR max', false);
        break;
      case 'POR rotation':
        put(largest(commanded, 3), 'POR max', false);
        break;
      case 'POR acceleration': {
        const [move, swing] = [largest(behind, 0), largest(behind, 3)];
        const moves = Math.abs(behind[move] ?? 0) / speed >= Math.abs(behind[swing] ?? 0) / turn;
        put(moves ? move : swing, 'POR accel', false);
        break;
      }
      case 'joint rate':
      case 'soft stop':
      case 'hard stop':
        put(largest(commanded, moving), joints[limit.joint]?.label ?? 'joint', true);
        break;
      case 'singularity':
        put(largest(commanded, moving), 'singular', true);
        break;
      case 'seat':
      case 'contact':
      case 'switch':
        put(largest(commanded, moving), limit.kind, true);
        break;
    }
  }
  return tags;
}

/** Returns the row of the value with the largest magnitude, out of the three rows that start at `first`. */
function largest(values: readonly number[], first: number): number {
  const sizes = values.slice(first, first + 3).map(Math.abs);
  return first + sizes.indexOf(Math.max(...sizes));
}

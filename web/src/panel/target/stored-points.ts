/** AUTO MODES of SPEC 94: the points stored for AUTO 1-4, and the numbers of the next and the last point. */

import type { Frame, StoredPoint, StoredSequence } from '../../link/protocol';
import { attitude, fixed } from '../../words/format';
import type { Unit, Units } from '../../words/units';
import { button, el, setAttribute, setClass, setPressed, setText } from '../parts/dom';

/** Items of SPEC 94. */
const SLOTS: readonly (readonly [item: number, position: string])[] = [
  [13, 'AUTO 1'],
  [14, 'AUTO 2'],
  [15, 'AUTO 3'],
  [16, 'AUTO 4'],
];
/** Number of points that are visible at once. */
const ROWS = 5;

export interface StoredPoints {
  readonly element: HTMLElement;
  set(frame: Frame, units: Units): void;
}

export function storedPoints(sequences: readonly StoredSequence[]): StoredPoints {
  /**
   * The sequence that the user has selected for display. If null, the entered AUTO mode's sequence is displayed or, in
   * another mode, the first sequence with points.
   */
  let chosen: string | null = null;
  let entered = '';
  const keys = SLOTS.map(([item, position]) => {
    const points = pointsOf(position).length;
    const key = button(
      { title: points > 0 ? `${points} points` : 'No points are stored' },
      [el('i', { class: 'item' }, String(item)), position],
      () => {
        chosen = position;
      },
    );
    setClass(key, 'absent', points === 0);
    return key;
  });
  const unit = el('i');
  const head = ['', 'X ', 'Y ', 'Z ', 'Pitch', 'Yaw', 'Roll', ''].map((name) =>
    el(
      'th',
      { scope: 'col' },
      name,
      ...(name === 'X ' ? [unit] : name === 'Pitch' ? [el('i', {}, ' °')] : []),
    ),
  );
  const rows = Array.from({ length: ROWS }, () => {
    const cells = Array.from({ length: 8 }, () => el('td'));
    return { cells, row: el('tr', {}, ...cells) };
  });
  const words = el('p');
  const table = el(
    'table',
    {},
    el('thead', {}, el('tr', {}, ...head)),
    el('tbody', {}, ...rows.map(({ row }) => row)),
  );
  const element = el(
    'div',
    { class: 'stored-points' },
    el('h3', {}, 'Auto modes'),
    el('div', { class: 'switch plain', role: 'group', 'aria-label': 'Stored points of' }, ...keys),
    table,
    words,
  );

  function pointsOf(position: string): readonly StoredPoint[] {
    return sequences.find((each) => each.position === position)?.points ?? [];
  }

  return {
    element,
    set(frame, { length }) {
      if (frame.mode !== entered) chosen = null;
      entered = frame.mode;
      const position =
        chosen ?? (entered.startsWith('AUTO') ? entered : (sequences[0]?.position ?? 'AUTO 1'));
      const points = pointsOf(position);
      const next = startPoint(position, frame, points.length);
      SLOTS.forEach(([, name], i) => {
        const key = keys[i];
        if (key) setPressed(key, name === position && points.length > 0);
      });
      setText(unit, length.name);
      table.hidden = points.length === 0;
      const first = firstShown(next, points.length);
      rows.forEach(({ cells, row }, i) => {
        const point = points[first + i];
        row.hidden = point === undefined;
        const shown = point ? line(first + i + 1, point, length) : [];
        cells.forEach((cell, k) => {
          setText(cell, shown[k] ?? '');
        });
        const comes = point !== undefined && first + i + 1 === next;
        setClass(row, 'next', comes);
        setAttribute(row, 'aria-current', String(comes));
      });
      setText(
        words,
        points.length === 0 ? 'No points are stored.' : `17 START PT ${next}   LAST PT ${points.length}`,
      );
    },
  };
}

/** Returns the number of the point to which a sequence moves, or with which it will begin. */
export function startPoint(
  position: string,
  { mode, point }: Pick<Frame, 'mode' | 'point'>,
  points: number,
): number {
  if (position !== mode) return Math.min(1, points);
  return point > points ? 1 : point; // a complete sequence begins again at its first point
}

/** Returns the index (from 0) of the point in the first row, so that point number `next` (from 1) is visible. */
export function firstShown(next: number, points: number): number {
  return Math.max(0, Math.min(next - 2, points - ROWS));
}

function line(
  number: number,
  { position, attitude: turned, pause }: StoredPoint,
  length: Unit,
): readonly string[] {
  const places = position.map((value) => fixed(value * length.perSi, length.decimals));
  return [String(number), ...places, ...turned.map(attitude), pause ? 'pause' : 'fly by'];
}

/**
 * The remaining motion to the place where the task needs the end effector or the payload, in components along the
 * axes of the sticks. Beside each component is the key, button or axis that reduces it; small components are green.
 */

import type { Names } from '../input/active-device';
import type { Display, JointInfo, TaskPair, ToGo, Vec3 } from '../link/protocol';
import { el, setAttribute, setClass, setText } from '../panel/parts/dom';
import { degrees, fixed, lengthText, small } from '../words/format';
import { jointCalled, motionText } from '../words/joint';
import type { Units } from '../words/units';

const MOVES = ['X', 'Y', 'Z'] as const;
const TURNS = ['roll', 'pitch', 'yaw'] as const;
/** A component that is a smaller part of the tolerance than this needs no motion. */
const LEAST = 0.2;
/** A smaller speed is not shown [m/s]. */
const AT_REST = 0.002;

/** The joints of the arm: a joint that slides has a length to go. */
type Joints = readonly Pick<JointInfo, 'name' | 'slides'>[];

export interface GoPart {
  /** Axis of the stick: `Z`, `yaw`. */
  readonly axis: string;
  /** Axis and direction of the stick: `−Z`, `+yaw`; without a direction if no motion is needed. */
  readonly stick: string;
  /** Key, button or axis; empty if no motion is needed. */
  readonly handle: string;
  /** Magnitude with its unit. */
  readonly value: string;
  /** Whether the component is within the tolerance. */
  readonly near: boolean;
}

/** Returns the components that are left: three of translation and three of rotation; for a joint only one, without a key. */
export function goParts(go: ToGo, units: Units, names: Names, joints: Joints): readonly GoPart[] {
  if (go.shift.length === 0) {
    const write = (size: number) => jointMotion({ ...go, angle: size }, units, joints);
    return [part('', '', go.angle, go.near[1], write, names)];
  }
  const moves = components(go.translation, MOVES, go.near[0], (size) => lengthText(size, units), names);
  return [...moves, ...components(go.rotation, TURNS, go.near[1], angle, names)];
}

/** Distance and angle as a text: `12.3 in, 4.5°`; for a joint, one of the two. */
export function goWords(go: ToGo, units: Units, joints: Joints): string {
  if (go.shift.length === 0) return jointMotion(go, units, joints);
  return `${lengthText(go.distance, units)}, ${angle(Math.abs(go.angle))}`;
}

function jointMotion({ to, angle }: ToGo, units: Units, joints: Joints): string {
  return motionText(jointCalled(to, joints) ?? { slides: false }, angle, units);
}

/** Speed towards the place, as a text: `0.12 ft/s`; empty at rest and for a joint. */
export function closingWords({ closing }: Pick<ToGo, 'closing'>, { speed }: Pick<Units, 'speed'>): string {
  if (closing === null || Math.abs(closing) < AT_REST) return '';
  return `${fixed(Math.abs(closing) * speed.perSi, speed.decimals, false)} ${speed.name}${closing < 0 ? ' away' : ''}`;
}

export function isThere(go: ToGo): boolean {
  return go.distance <= go.near[0] && Math.abs(go.angle) <= go.near[1];
}

function components(
  sizes: Vec3 | null,
  axes: readonly string[],
  near: number,
  write: (size: number) => string,
  names: Names,
): readonly GoPart[] {
  return sizes ? axes.map((axis, i) => part(axis, axis, sizes[i] ?? 0, near, write, names)) : [];
}

/** `label`: name of the axis in the text; `axis`: the axis in the names of the functions. */
function part(
  label: string,
  axis: string,
  size: number,
  near: number,
  write: (size: number) => string,
  names: Names,
): GoPart {
  const sign = size > 0 ? '+' : '-';
  const still = Math.abs(size) < LEAST * near;
  const share = label === '' ? 1 : 1 / Math.sqrt(3); // three such components together are within the tolerance
  return {
    axis: label,
    stick: still ? label : `${sign === '-' ? '−' : '+'}${label}`,
    handle: still || axis === '' ? '' : names.short(`${sign}${axis}`),
    value: write(Math.abs(size)),
    near: Math.abs(size) <= near * share,
  };
}

function angle(size: number): string {
  return `${degrees(size, 1, false)}°`;
}

/** Clearance of the pair that the task brings together, as a text: `clearance 3.1 in`. */
export function apartWords({ clearance }: Pick<TaskPair, 'clearance'>, { gap }: Pick<Units, 'gap'>): string {
  return `clearance ${small(clearance, gap)} ${gap.name}`;
}

/** What is left of a step: the remaining motion, and the pair of parts that it brings together. */
export type Left = Pick<Display, 'to_go' | 'task_pair'>;
export const NOTHING_LEFT: Left = { to_go: null, task_pair: null };

/** Element with the remaining motion: a head, and a cell for each component. */
export function goElement(joints: Joints) {
  const cells = Array.from({ length: 6 }, () => {
    const [handle, value] = [el('kbd'), el('span')];
    return { element: el('li', {}, handle, value), handle, value };
  });
  const [head, total, speed] = [el('span', { class: 'head' }), el('b'), el('span', { class: 'closing' })];
  const apart = el('span', { class: 'apart' });
  const list = el('ol', {}, ...cells.map((cell) => cell.element));
  const element = el(
    'div',
    { class: 'to-go', role: 'group' },
    el('p', {}, head, ' ', total, ' ', el('span', { class: 'rates' }, speed, ' ', apart)),
    list,
  );
  return {
    element,
    set({ to_go: go, task_pair }: Left, units: Units, names: Names) {
      element.hidden = go === null;
      if (!go) return;
      const parts = goParts(go, units, names, joints);
      setText(head, `to ${go.to}`);
      setText(total, goWords(go, units, joints));
      setText(speed, closingWords(go, units));
      setText(apart, task_pair ? apartWords(task_pair, units) : '');
      setAttribute(apart, 'title', task_pair ? `${task_pair.a} to ${task_pair.b}` : '');
      setClass(element, 'there', isThere(go));
      const sentence = goSentence(go, units, names, joints);
      setAttribute(element, 'aria-label', sentence);
      setAttribute(element, 'title', sentence);
      list.hidden = parts.length === 0;
      cells.forEach((cell, i) => {
        const each = parts[i];
        cell.element.hidden = each === undefined;
        if (!each) return;
        setText(cell.handle, each.handle || each.axis);
        setClass(cell.handle, 'axis', each.handle === '');
        setText(cell.value, each.value);
        setAttribute(cell.element, 'title', each.near ? `${each.stick}, within tolerance` : each.stick);
        setClass(cell.element, 'near', each.near);
      });
    },
  };
}

/** Returns the remaining motion as a sentence, with the controls for it. */
export function goSentence(go: ToGo, units: Units, names: Names, joints: Joints): string {
  const flown = goParts(go, units, names, joints).filter(({ handle }) => handle !== '');
  const words = flown.map(({ stick, handle, value }) => `${stick} (${handle}) ${value}`).join(', ');
  const place = `To ${go.to}: ${goWords(go, units, joints)}`;
  if (isThere(go)) return `${place}; there.`;
  return words ? `${place}; ${words}.` : `${place}.`;
}

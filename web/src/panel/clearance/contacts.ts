/** Contacts, and the escape directions from detrimental contacts, in a few lines. */

import type { Names } from '../../input/active-device';
import type { Frame, Welcome, Work } from '../../link/protocol';
import { capitalised, small } from '../../words/format';
import type { Units } from '../../words/units';
import { contactWays } from '../../words/way-out';
import { el } from '../parts/dom';

export interface Line {
  readonly text: string;
  readonly level: 'info' | 'caution' | 'warning';
}

export interface Touching {
  readonly element: HTMLElement;
  /** Writes the lines of a frame; returns whether any of them is a caution or a warning. */
  set(frame: Pick<Frame, 'work' | 'ways_out' | 'dynamics'>, units: Units, names: Names): boolean;
}

export function touching({ joints }: Pick<Welcome, 'joints'>): Touching {
  const list = el('ul', { class: 'touching' });
  let shown = '';
  return {
    element: list,
    set(frame, units, names) {
      const lines = linesOf(frame, joints, units, names);
      const key = lines.map(({ level, text }) => `${level} ${text}`).join('\n');
      if (key !== shown) {
        shown = key;
        list.replaceChildren(
          ...lines.map(({ level, text }) =>
            el('li', { class: level, title: text }, el('i', { class: 'sign' }), el('span', {}, text)),
          ),
        );
      }
      return lines.some(({ level }) => level !== 'info');
    },
  };
}

/** Least force that is displayed [N]. */
const LEAST_FORCE = 5;

/** Returns a line for each detrimental contact (deepest first), each escape direction, all essential contacts, and the
 * forces that hold payloads. */
export function linesOf(
  {
    work: { contacts },
    ways_out,
    dynamics,
  }: { readonly work: Pick<Work, 'contacts'> } & Pick<Frame, 'ways_out' | 'dynamics'>,
  joints: Welcome['joints'],
  { gap }: Units,
  names: Names,
): readonly Line[] {
  const force = (a: string, b: string) =>
    newtons(Math.hypot(...(dynamics?.contacts.find((one) => one.a === a && one.b === b)?.force ?? [0])));
  const harmful = contacts
    .filter(({ essential }) => !essential)
    .sort((a, b) => a.clearance - b.clearance)
    .map(({ a, b, clearance }) => {
      const deep = clearance < 0 ? `, ${small(-clearance, gap)} ${gap.name} deep` : '';
      return `${a} touches ${b}${deep}${force(a, b)}`;
    });
  const ways = contactWays(ways_out, joints, names).map((way) => `Escape: ${way}`);
  const essential = contacts.filter((each) => each.essential).map(({ a, b }) => `${a} – ${b}${force(a, b)}`);
  const holding = (dynamics?.holds ?? [])
    .filter((each) => each.force >= LEAST_FORCE)
    .map(
      ({ by, force: held }): Line => ({
        text: `${by === 'end effector' ? 'Grasp' : 'Berth'}${newtons(held)}`,
        level: 'info',
      }),
    );
  return [
    ...harmful.map((text): Line => ({ text: capitalised(text), level: 'warning' })),
    ...ways.map((text): Line => ({ text, level: 'caution' })),
    ...essential
      .slice(0, 1)
      .map((): Line => ({ text: `Essential contact: ${essential.join(', ')}`, level: 'info' })),
    ...holding,
  ];
}

/** Returns a force with two digits, after a comma; empty if it is too small to be displayed. */
function newtons(force: number): string {
  return force < LEAST_FORCE ? '' : `, ${String(Number(force.toPrecision(2)))} N`;
}

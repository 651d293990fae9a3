/**
 * Stick displays, a square for the THC and a circle for the RHC. A mark shows the deflection that the displayed frame
 * used. Under RATE HOLD, a second mark shows this deflection, which corresponds to the kept rates. On the operator's
 * page, the first mark then shows the present deflection.
 */

import type { ControllersShown } from '../../input/controllers';
import type { Hand } from '../../input/deflection';
import { fixed } from '../../words/format';
import { el, setAbout, setAttribute, setClass, setText, svg } from '../parts/dom';
import type { View } from '../parts/part';

const REACH = 40;

/** A hollow mark with a stem, at (x, y); both in [-1, 1], y upwards. */
interface Mark {
  readonly element: SVGGElement;
  set(x: number, y: number): void;
}

/**
 * Makes a mark. The mark for the rates that RATE HOLD keeps (`held`) is dashed and has no stem. While it is at the
 * centre, it is hidden.
 */
export function mark(held = false): Mark {
  const stem = svg('line', { class: 'stem', x1: '0', y1: '0', x2: '0', y2: '0' });
  const ring = svg('circle', { class: 'mark', r: held ? '8.5' : '5.5', cx: '0', cy: '0' });
  const element = svg('g', held ? { class: 'held' } : {}, stem, ring);
  return {
    element,
    set(x, y) {
      if (held) setClass(element, 'middle', x === 0 && y === 0);
      const [h, v] = [(x * REACH).toFixed(1), (-y * REACH).toFixed(1)];
      setAttribute(stem, 'x2', h);
      setAttribute(stem, 'y2', v);
      setAttribute(ring, 'cx', h);
      setAttribute(ring, 'cy', v);
    },
  };
}

/** Makes the deadband ring of a stick display, and the cross and the text that report a lost device. */
export function gone(cross: string): {
  readonly ring: SVGElement;
  readonly cross: SVGElement;
  readonly words: HTMLElement;
  set(section: HTMLElement, shown: ControllersShown, hand: Hand): void;
} {
  const ring = svg('circle', { class: 'dead', r: '0' });
  const words = el('b', { class: 'gone' });
  return {
    ring,
    cross: svg('path', { class: 'crossed', d: cross }),
    words,
    set(section, shown, hand) {
      const name = shown.gone[hand];
      setAttribute(ring, 'r', (shown.deadband[hand] * REACH).toFixed(1));
      setClass(section, 'lost', name !== null);
      setText(words, name === null ? '' : `${name} lost`);
    },
  };
}

/** Makes a row of three numbers, each after its letter. */
export function triple(letters: readonly [string, string, string]): {
  element: HTMLElement;
  /** `first` replaces the letter of the first number. */
  set(values: readonly [number, number, number], first?: string): void;
} {
  const fields = letters.map((text) => ({
    letter: el('i', {}, text),
    value: el('span', { class: 'value' }, '+0.00'),
  }));
  const element = el(
    'div',
    { class: 'triple', 'data-calm': 'full' },
    ...fields.map(({ letter, value }) => el('span', { class: 'axis' }, letter, value)),
  );
  return {
    element,
    set(values, first) {
      if (first && fields[0]) setText(fields[0].letter, first);
      fields.forEach(({ value }, i) => {
        setText(value, fixed(values[i] ?? 0, 2));
      });
    },
  };
}

/**
 * Writes who moves the sticks after the group's title: the autopilot; on the operator's page `hand`, such as `left hand`;
 * on an observer's page the operator's name.
 */
export function setHand(
  section: HTMLElement,
  hand: string,
  { frame, flying, flier }: Pick<View, 'frame' | 'flying' | 'flier'>,
): void {
  const { autopilot } = frame.display;
  setAbout(section, autopilot !== null ? `${autopilot} flies` : flying ? hand : (flier ?? ''));
}

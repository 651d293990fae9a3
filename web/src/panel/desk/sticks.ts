/**
 * Stick displays: the deflections used in the displayed frame, on the THC's square and the RHC's round. Under RATE HOLD
 * a second mark shows the rates held, and the first one the present deflection.
 */

import type { ControllersShown } from '../../input/controllers';
import type { Hand } from '../../input/deflection';
import { fixed } from '../../words/format';
import { el, setAbout, setAttribute, setClass, setText, svg } from '../parts/dom';
import type { View } from '../parts/part';

const REACH = 40;

/** A hollow mark with a stem, at (x, y), each in [-1, 1], y upwards. */
interface Mark {
  readonly element: SVGGElement;
  set(x: number, y: number): void;
}

/** A `held` mark is dashed, has no stem, and is visible only off the middle. */
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

/** A stick display's deadband ring, and the cross and words that report a lost device. */
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
      setText(words, name === null ? '' : `${name} is gone`);
    },
  };
}

/** Three numbers in a row, each after its letter. */
export function triple(letters: readonly [string, string, string]): {
  element: HTMLElement;
  /** `first` renames the first number. */
  set(values: readonly [number, number, number], first?: string): void;
} {
  const fields = letters.map((text) => ({
    letter: el('i', {}, text),
    value: el('span', { class: 'value' }, '+0.00'),
  }));
  const element = el(
    'div',
    { class: 'triple' },
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

/** Writes after the group's title who moves the sticks. */
export function setHand(
  section: HTMLElement,
  hand: string,
  { frame, flying, flier }: Pick<View, 'frame' | 'flying' | 'flier'>,
): void {
  setAbout(section, frame.by === 'script' ? 'script flies' : flying ? hand : (flier ?? ''));
}

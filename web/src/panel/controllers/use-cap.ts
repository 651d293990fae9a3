/** Key cap that shows the keys or buttons of a function. To change the assignment, the user presses the cap. */

import { labelOf } from '../../input/keymap';
import { nameOfSource } from '../../input/layout';
import type { Kind } from '../../input/mapping';
import { isFixed, movers } from '../../input/rebind';
import { mappingOf } from '../../input/store';
import { button, setClass } from '../parts/dom';

export interface UseCap {
  readonly element: HTMLButtonElement;
  readonly use: string;
  /** Keys and buttons of the function. */
  readonly sources: readonly string[];
}

export function useCap(kind: Kind, use: string, ask: (use: string) => void): UseCap {
  const moving = movers(mappingOf(kind), use);
  const names = moving.map(({ source, sign }) => nameOfSource(kind, source, sign));
  const fixed = isFixed(kind, use);
  const text = names.join(' · ') || '·';
  const attributes = {
    class: 'cap',
    'data-use': use,
    'aria-label': `${labelOf(use)}: ${names.join(', ') || 'nothing'}`,
    ...(fixed ? { disabled: '', title: 'This key is fixed' } : { title: `${labelOf(use)}: press to change` }),
  };
  const element = button(attributes, [text], () => ask(use));
  setClass(element, 'none', names.length === 0);
  return { element, use, sources: moving.map(({ source }) => source) };
}

/** Marks the cap of the function `asked`, for which the sheet waits for a press or a movement. */
export function markAsked(caps: readonly UseCap[], asked: string | null): void {
  for (const { element, use } of caps) setClass(element, 'asked', use === asked);
}

/** Lights the caps whose keys or buttons are pressed. */
export function lightCaps(caps: readonly UseCap[], down: ReadonlySet<string>): void {
  for (const { element, sources } of caps) {
    const held = sources.some((source) => source.split('+').every((part) => down.has(part)));
    setClass(element, 'held', held);
  }
}

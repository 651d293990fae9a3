/** Table of the functions that act once or after a hold, with a key cap for each. */

import { labelOf, USES } from '../../input/keymap';
import type { Kind } from '../../input/mapping';
import { el } from '../parts/dom';
import { lightCaps, markAsked, type UseCap, useCap } from './use-cap';

export class UseTable {
  readonly element = el('div', { class: 'uses' });
  private caps: readonly UseCap[] = [];

  constructor(private readonly asked: (use: string) => void) {}

  fill(kind: Kind): void {
    const names = [...USES.values()].filter(({ does }) => does.kind !== 'axis').map(({ name }) => name);
    const cameras = names.filter((name) => name.startsWith('camera '));
    const all = new Map(names.map((name) => [name, useCap(kind, name, this.asked)]));
    const rows = names
      .filter((name) => !cameras.includes(name))
      .map((name) => el('div', { class: 'row' }, el('span', {}, labelOf(name)), ...cap(all, name)));
    const row = el(
      'div',
      { class: 'row cameras-row' },
      el('span', {}, 'camera 1 to 10'),
      el('div', { class: 'ten' }, ...cameras.flatMap((name) => cap(all, name))),
    );
    this.caps = [...all.values()];
    this.element.replaceChildren(
      el('h3', {}, 'Keys and buttons'),
      el('div', { class: 'grid' }, ...rows, row),
    );
  }

  ask(use: string | null): void {
    markAsked(this.caps, use);
  }

  light(down: ReadonlySet<string>): void {
    lightCaps(this.caps, down);
  }
}

function cap(all: ReadonlyMap<string, UseCap>, name: string): readonly HTMLElement[] {
  const found = all.get(name);
  return found ? [found.element] : [];
}

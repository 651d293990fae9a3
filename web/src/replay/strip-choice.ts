/** Button that opens a list of strips; the user chooses from the list. */

import type { Strip } from '../link/protocol';
import { button, el, setPressed } from '../panel/parts/dom';

export class StripChoice {
  readonly element: HTMLElement;
  private readonly list: HTMLElement;
  private readonly key: HTMLButtonElement;
  private readonly choices;
  private names: readonly string[];

  /** `most`: greatest number of strips. */
  constructor(
    strips: readonly Strip[],
    private readonly most: number,
    private readonly changed: (names: readonly string[]) => void,
  ) {
    this.names = strips.filter((strip) => strip.shown).map(({ name }) => name);
    this.choices = strips.map(({ name }) => ({
      name,
      key: button({}, [name], () => this.choose(name)),
    }));
    this.list = el(
      'div',
      { class: 'strip-list', role: 'group', 'aria-label': 'Strips', hidden: '' },
      ...this.choices.map(({ key }) => key),
    );
    this.key = button({ 'aria-expanded': 'false' }, ['Strips'], () => this.open(this.list.hidden === true));
    this.element = el('div', { class: 'strip-choice' }, this.key, this.list);
    this.mark();
  }

  /** The chosen strips, in this order. */
  get chosen(): readonly string[] {
    return this.names;
  }

  set disabled(on: boolean) {
    this.key.disabled = on;
    if (on) this.open(false);
  }

  open(on: boolean): void {
    this.list.hidden = !on;
    this.key.setAttribute('aria-expanded', String(on));
  }

  private choose(name: string): void {
    const without = this.names.filter((each) => each !== name);
    if (without.length === this.names.length) this.names = [...this.names, name];
    else if (without.length > 0) this.names = without;
    this.mark();
    this.changed(this.names);
  }

  private mark(): void {
    for (const { name, key } of this.choices) {
      const on = this.names.includes(name);
      setPressed(key, on);
      key.disabled = !on && this.names.length >= this.most;
    }
  }
}

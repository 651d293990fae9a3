/** Assigns conditions to cells. A condition keeps its cell while the set of conditions does not change. */

import type { Condition } from '../../link/protocol';

export class Places {
  private names: readonly string[] = [];

  constructor(private readonly most: number) {}

  /**
   * Returns the conditions to display, in the order of the cells. If there are enough cells, this is the order of the
   * argument. If not, failing conditions are chosen before the others. A condition that fails later replaces one that
   * holds, and all others keep their cells.
   */
  order(conditions: readonly Condition[]): readonly Condition[] {
    if (conditions.length <= this.most) {
      this.names = conditions.map(({ name }) => name);
      return conditions;
    }
    const known = new Map(conditions.map((each) => [each.name, each]));
    const fails = (name: string) => known.get(name)?.holds === false;
    const begin = this.names.length < this.most || !this.names.every((name) => known.has(name));
    const places = begin ? this.first(conditions) : [...this.names];
    for (const { name, holds } of conditions) {
      if (holds || places.includes(name)) continue;
      const free = places.findIndex((place) => !fails(place));
      if (free >= 0) places[free] = name;
    }
    this.names = places;
    return places.flatMap((name) => known.get(name) ?? []);
  }

  /** Returns a name for each cell, in the order of the argument. Failing conditions are chosen before the others. */
  private first(conditions: readonly Condition[]): string[] {
    const wanted = [...conditions.filter(({ holds }) => !holds), ...conditions.filter(({ holds }) => holds)];
    const chosen = new Set(wanted.slice(0, this.most));
    return conditions.filter((each) => chosen.has(each)).map(({ name }) => name);
  }
}

/** Cells of conditions: each condition keeps its cell as long as the set of conditions is the same. */

import type { Condition } from '../../link/protocol';

export class Places {
  private names: readonly string[] = [];

  constructor(private readonly most: number) {}

  /**
   * The displayed conditions, in the given order if there is a cell for each. Otherwise those that fail come first; one
   * that fails later replaces one that holds, and no other condition moves.
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

  /** As many conditions as there are cells, those that fail before those that hold, in the given order. */
  private first(conditions: readonly Condition[]): string[] {
    const wanted = [...conditions.filter(({ holds }) => !holds), ...conditions.filter(({ holds }) => holds)];
    const chosen = new Set(wanted.slice(0, this.most));
    return conditions.filter((each) => chosen.has(each)).map(({ name }) => name);
  }
}

/** Places of conditions: each keeps its place while they are the same ones. */

import type { Condition } from '../../link/protocol';

export class Places {
  private names: readonly string[] = [];

  constructor(private readonly most: number) {}

  /**
   * The conditions shown, in the order given where all find room. Where not, the first that fail are shown; one that
   * fails later takes the place of one that holds, and nothing else moves.
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

  /** Those that fail before those that hold, as many as find room, in the order given. */
  private first(conditions: readonly Condition[]): string[] {
    const wanted = [...conditions.filter(({ holds }) => !holds), ...conditions.filter(({ holds }) => holds)];
    const chosen = new Set(wanted.slice(0, this.most));
    return conditions.filter((each) => chosen.has(each)).map(({ name }) => name);
  }
}

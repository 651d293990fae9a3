/**
 * Resting places of a device's axes and buttons. An axis whose resting place is not known commands nothing: it may be the
 * trigger of a joystick, which rests at −1 and passes 0 when it is pulled.
 */

import { USES } from './keymap';
import { indexOf, type Mapping, shape } from './mapping';
import { type Reading, valueAt } from './reading';

/** Time without motion after which an axis counts as at rest [ms]: an axis that moves only passes zero. */
export const REST_MS = 1500;

export class Rest {
  /** Values of the assigned axes and buttons that are not at zero, and whose resting places are not known. */
  off: readonly number[] = [];
  private readonly known = new Set<string>();
  /** Time since which a source has been at zero [ms]. */
  private readonly since = new Map<string, number>();
  /** Axes that have moved since the first reading. */
  private readonly moved = new Set<string>();
  /** Whether the operator has set the present positions as zero since the last reading. */
  private told = false;

  /**
   * @param vouched whether an axis that is at zero in the first reading rests there. If not, it must also have moved,
   *     because some browsers report 0 for an axis until it moves.
   * @param first first reading; null if it is still to come.
   */
  constructor(
    private readonly vouched: boolean,
    private first: Reading | null = null,
  ) {}

  /** Returns whether the resting place of an axis or button is known. */
  knows(source: string): boolean {
    return this.known.has(source);
  }

  /** Called when the operator has set the present positions of the axes as zero. */
  set(): void {
    this.told = true;
  }

  /** Learns from a reading at `now` [ms]. */
  look(reading: Reading, mapping: Mapping, now: number): void {
    const first = this.first ?? reading;
    this.first = first;
    const isZero = (of: Reading, source: string) => shape(valueAt(of, source, mapping), mapping) === 0;
    const off: number[] = [];
    for (const [source, use] of Object.entries(mapping.bindings)) {
      if (USES.get(use)?.does.kind !== 'axis' || this.known.has(source)) continue;
      const axis = indexOf(source, 'a');
      if (axis !== null && reading.axes[axis] !== first.axes[axis]) this.moved.add(source);
      if (!isZero(reading, source)) {
        this.since.delete(source);
        off.push(valueAt(reading, source, mapping));
        continue;
      }
      const since = this.since.get(source) ?? now;
      this.since.set(source, since);
      const rested = now - since >= REST_MS && (this.vouched || this.moved.has(source));
      const atFirst = this.vouched && isZero(first, source);
      if (axis === null || rested || atFirst || this.told) this.known.add(source);
    }
    this.off = off;
    this.told = false;
  }
}

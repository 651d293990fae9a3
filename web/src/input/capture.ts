/** Waits for the next key, button or axis that the operator presses or moves. */

import type { Mapping } from './mapping';
import type { Reading } from './reading';
import type { Source } from './rebind';

/** An axis that moves farther than this is chosen. */
const MEANT = 0.5;

export class Capture {
  private before: Reading | null = null;
  /** A pressed button that, like Shift, changes the functions of other buttons. It is chosen if it is pressed alone. */
  private changer: number | null = null;

  constructor(private readonly mapping: Mapping) {}

  /** Returns the button or axis that was pressed or moved since the first reading; null if there is none. */
  look(reading: Reading | null): Source | null {
    if (!reading) return null;
    const before = this.before ?? reading;
    this.before = { axes: before.axes, buttons: reading.buttons.map((button) => ({ ...button })) };
    const axis = reading.axes.findIndex((value, i) => Math.abs(value - (before.axes[i] ?? 0)) > MEANT);
    if (axis >= 0) {
      const sign = (reading.axes[axis] ?? 0) < (before.axes[axis] ?? 0) ? -1 : 1;
      return { source: `a${axis}`, sign };
    }
    for (const [index, { pressed }] of reading.buttons.entries()) {
      const was = before.buttons[index]?.pressed ?? false;
      if (pressed && !was) {
        if (this.changer !== null) return { source: `b${this.changer}+b${index}`, sign: 1 };
        if (!this.changes(index)) return { source: `b${index}`, sign: 1 };
        this.changer = index;
      } else if (!pressed && was && index === this.changer) return { source: `b${index}`, sign: 1 };
    }
    return null;
  }

  private changes(index: number): boolean {
    return Object.keys(this.mapping.bindings).some((source) => source.startsWith(`b${index}+`));
  }
}

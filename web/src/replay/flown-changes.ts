/** Changes in flight of a recorded run: the fields of the welcome that are in force at each step. */

import { renew } from '../link/changed';
import type { PlaybackIndex } from '../link/protocol';

export class FlownChanges {
  private present = 0;

  constructor(private readonly index: Pick<PlaybackIndex, 'welcome' | 'changed'>) {}

  /** Sets the fields of the welcome that are in force at a step; returns whether they are others than before. */
  show(tick: number): boolean {
    const { welcome, changed } = this.index;
    const past = changed.filter((one) => one.tick <= tick).length;
    const now = changed[past - 1];
    if (past === this.present || !now) return false;
    this.present = past;
    renew(welcome, now.fields);
    return true;
  }
}

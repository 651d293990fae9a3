/**
 * Finds the key whose release never arrived. A held key repeats, but only the key that was pressed last, and some
 * systems send no repeats. So only a key that has repeated, and then stops without another key's event, was released.
 */

import { Silence } from '../basics/silence';

/** Time without a repeat after which a key that was repeating counts as released [ms]. */
const SILENT_MS = 1000;
/** Greatest time between two readings that counts [ms]: a page that stands still receives repeats late. */
const MOST_MS = 250;

export class Repeats {
  /** The key that repeats now; null if none does. */
  private code: string | null = null;
  private readonly silence = new Silence(MOST_MS);

  /** Called for the press, the repeat or the release of any key. */
  heard({
    type,
    code,
    repeat,
    timeStamp,
  }: Pick<KeyboardEvent, 'type' | 'code' | 'repeat' | 'timeStamp'>): void {
    if (type === 'keydown' && repeat) this.code = code;
    else this.code = null;
    this.silence.end(timeStamp);
  }

  /** Returns at `now` [ms] the key whose repeats have stopped, once; null if there is none. */
  stopped(now: number): string | null {
    const { code } = this;
    if (this.silence.at(now) < SILENT_MS || code === null) return null;
    this.code = null;
    return code;
  }
}

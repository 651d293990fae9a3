/** Appearance of the page and its pictures, stored in the browser and the same in all windows of this browser. */

import type { Keeper } from './local-storage';

const KEPT = 'aftdeck.appearance';

export type Seventies = readonly [boolean, boolean, boolean];

export interface Looks {
  /** Television of the early flights: black and white, with noise. */
  readonly early: boolean;
  /** Dim for a dark room: the page at 55 % and the pictures at 75 % of their brightness. */
  readonly night: boolean;
  /** For MON 1, MON 2 and the view of all cameras: whether they have the look of 1972. */
  readonly seventies: Seventies;
}

const FRESH: Looks = { early: false, night: false, seventies: [false, false, false] };

/** Returns the stored appearance, or the default if `text` cannot be decoded. */
export function looksOf(text: string | null): Looks {
  if (text === null) return FRESH;
  try {
    const { early, night, seventies } = JSON.parse(text) as Partial<Looks>;
    const [first, second, all] = Array.isArray(seventies) ? seventies : [];
    const looks: Seventies = [first === true, second === true, all === true];
    return { early: early === true, night: night === true, seventies: looks };
  } catch {
    return FRESH;
  }
}

export class Appearance {
  private looks: Looks;

  /** `changed` receives the appearance: once in the constructor, and after each change. */
  constructor(
    private readonly store: Keeper,
    private readonly changed: (looks: Looks) => void,
  ) {
    this.looks = looksOf(store.getItem(KEPT));
    changed(this.looks);
  }

  get early(): boolean {
    return this.looks.early;
  }

  get night(): boolean {
    return this.looks.night;
  }

  get seventies(): Seventies {
    return this.looks.seventies;
  }

  set(change: Partial<Looks>): void {
    this.looks = { ...this.looks, ...change };
    this.store.setItem(KEPT, JSON.stringify(this.looks));
    this.changed(this.looks);
  }

  /** Applies changes that other windows of this browser make, until `signal` is aborted. */
  follow(signal: AbortSignal): void {
    window.addEventListener(
      'storage',
      ({ key, newValue }) => {
        if (key !== KEPT) return;
        this.looks = looksOf(newValue);
        this.changed(this.looks);
      },
      { signal },
    );
  }
}

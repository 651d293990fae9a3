/** A page and the windows torn off it: what the monitors show, where the playhead is, and keys that act from all. */

import type { Relayed } from '../input/key-relay';
import { pageName } from '../link/identity';
import type { UnitName } from '../words/units';

export type Torn = 0 | 1 | 'matrix' | 'strips';

/** What a page shows; it says so when it is asked, and whenever something of it changes. */
export interface PageState {
  readonly kind: 'page';
  readonly monitors: readonly (readonly string[])[];
  readonly plane: boolean;
  readonly units: UnitName;
  /** It takes the keys of its windows: it flies, or it plays. */
  readonly takesKeys: boolean;
}

/** Where the page that plays is in its recording. */
export interface Playhead {
  readonly kind: 'head';
  /** [s] */
  readonly position: number;
  readonly speed: number;
}

/** What page and windows say to each other. */
export type Said =
  | PageState
  | Playhead
  /** The page is closed or reloaded. */
  | { readonly kind: 'gone' }
  /** A window asks what its page shows. */
  | { readonly kind: 'ask' }
  /** The window of a monitor has the focus: camera keys act on it. */
  | { readonly kind: 'take'; readonly monitor: 0 | 1 }
  | Relayed
  | { readonly kind: 'show'; readonly monitor: 0 | 1; readonly names: readonly string[] }
  | { readonly kind: 'put'; readonly name: string }
  | { readonly kind: 'seek'; readonly position: number };

/** As `?view=` names them. */
const VIEWS: readonly (readonly [string, Torn])[] = [
  ['mon1', 0],
  ['mon2', 1],
  ['matrix', 'matrix'],
  ['strips', 'strips'],
];
/** Names the page that a window was torn off. */
const OF = 'of';

/** Text for a browser that blocks the window. */
export const BLOCKED = 'Pop-ups are blocked: allow them for this page, then press ↗ again.';

/** The way between one page and its windows; other pages of the browser have their own. */
export class Windows {
  private readonly channel: BroadcastChannel;

  constructor(page: string, heard: (said: Said) => void) {
    this.channel = new BroadcastChannel(`aftdeck ${page}`);
    this.channel.addEventListener('message', ({ data }: MessageEvent<Said>) => heard(data));
  }

  say(said: Said): void {
    this.channel.postMessage(said);
  }

  dispose(): void {
    this.channel.close();
  }
}

/** What a page was asked to show alone, by its address; null: the whole station. */
export function tornHere(search: string): Torn | null {
  const asked = new URLSearchParams(search).get('view');
  return VIEWS.find(([name]) => name === asked)?.[1] ?? null;
}

/** The page that a window was torn off, by its address; null: it was opened by hand. */
export function tornOff(search: string): string | null {
  return new URLSearchParams(search).get(OF);
}

/** Opens a window of its own, or brings it to the front; false: the browser did not let it. */
export function tearOff(what: Torn): boolean {
  const [name] = VIEWS.find(([, torn]) => torn === what) ?? VIEWS[0] ?? ['mon1'];
  const address = new URL(location.href);
  address.searchParams.set('view', name);
  address.searchParams.set(OF, pageName());
  return window.open(address, `aftdeck-${pageName()}-${name}`, 'popup,width=960,height=680') !== null;
}

/** The page that flies and the windows torn off it, in one browser: one set of monitors, and keys that fly from all. */

import type { Relayed } from './input/key-relay';

export type Torn = 0 | 1 | 'matrix';

/** What windows say to each other. */
export type Said =
  | { readonly kind: 'ask' }
  | { readonly kind: 'shown'; readonly monitors: readonly (readonly string[])[]; readonly plane: boolean }
  /** A page flies and takes keys, or does so no longer. */
  | { readonly kind: 'flier'; readonly page: string; readonly there: boolean }
  /** The window of a monitor has the focus: camera keys act on it. */
  | { readonly kind: 'take'; readonly monitor: 0 | 1 }
  | Relayed
  | { readonly kind: 'show'; readonly monitor: 0 | 1; readonly names: readonly string[] }
  | { readonly kind: 'put'; readonly name: string };

const CHANNEL = 'aftdeck';
/** As `?view=` names them. */
const VIEWS: readonly (readonly [string, Torn])[] = [
  ['mon1', 0],
  ['mon2', 1],
  ['matrix', 'matrix'],
];

export class Windows {
  private readonly channel = new BroadcastChannel(`${CHANNEL} ${location.host}`);

  constructor(heard: (said: Said) => void) {
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

/** Opens a window of its own; one that is open already comes to the front. */
export function tearOff(what: Torn): void {
  const [name] = VIEWS.find(([, torn]) => torn === what) ?? VIEWS[0] ?? ['mon1'];
  const address = new URL(location.href);
  address.searchParams.set('view', name);
  window.open(address, `aftdeck-${name}`, 'popup,width=960,height=680');
}

/** Messages between a page and its secondary windows: cameras of the monitors, playhead, and keys. */

import type { Relayed } from '../input/key-relay';
import { pageName } from '../link/identity';
import type { UnitName } from '../words/units';

/** Content of a window with pictures: a monitor, or all cameras. */
export type Pictured = 0 | 1 | 'matrix';
/** Content of a window: pictures, strips, or what decides the order in the picture of MON 1 or MON 2. */
export type Torn = Pictured | 'strips' | Planes;
export type Planes = (typeof PLANES)[number];

/** Windows with the planes of MON 1 and of MON 2. */
export const PLANES = ['planes1', 'planes2'] as const;

export function showsPlanes(torn: Torn | null): torn is Planes {
  return torn === PLANES[0] || torn === PLANES[1];
}

/** State of a page, sent on request and after each change. */
export interface PageState {
  readonly kind: 'page';
  readonly monitors: readonly (readonly string[])[];
  readonly plane: boolean;
  /** Whether bending is drawn exaggerated. */
  readonly bending: boolean;
  readonly units: UnitName;
  /** Whether keys pressed in the windows act on the page: true if the page is in control, or plays back a recording. */
  readonly takesKeys: boolean;
}

/** Playhead of a page that plays back a recording. */
export interface Playhead {
  readonly kind: 'head';
  /** [s] */
  readonly position: number;
  readonly speed: number;
}

/** Messages that a page and its windows exchange. */
export type WindowMessage =
  | PageState
  | Playhead
  /** The page is being closed or reloaded. */
  | { readonly kind: 'gone' }
  /** A window requests the state of its page. */
  | { readonly kind: 'ask' }
  /** The window of a monitor has the focus: camera keys act on it. */
  | { readonly kind: 'take'; readonly monitor: 0 | 1 }
  | Relayed
  | { readonly kind: 'show'; readonly monitor: 0 | 1; readonly names: readonly string[] }
  | { readonly kind: 'put'; readonly name: string }
  | { readonly kind: 'seek'; readonly position: number };

/** Values of `?view=`. */
const VIEWS: readonly (readonly [string, Torn])[] = [
  ['mon1', 0],
  ['mon2', 1],
  ['matrix', 'matrix'],
  ['strips', 'strips'],
  ...PLANES.map((name) => [name, name] as const),
];
/** Parameter of a window's address; its value is the name of the window's page. */
const OF = 'of';

/** Message to the user if the browser has blocked a window. */
export const BLOCKED = 'Pop-ups are blocked: allow them for this page, then press ↗ again.';

/** Channel between one page and its windows; each page of the browser has a separate channel. */
export class Windows {
  private readonly channel: BroadcastChannel;

  constructor(page: string, heard: (message: WindowMessage) => void) {
    this.channel = new BroadcastChannel(`aftdeck ${page}`);
    this.channel.addEventListener('message', ({ data }: MessageEvent<WindowMessage>) => heard(data));
  }

  say(message: WindowMessage): void {
    this.channel.postMessage(message);
  }

  dispose(): void {
    this.channel.close();
  }
}

/** View of a secondary window, from its address; null for the whole station. */
export function tornHere(search: string): Torn | null {
  const asked = new URLSearchParams(search).get('view');
  return VIEWS.find(([name]) => name === asked)?.[1] ?? null;
}

/** Name of a secondary window's page, from its address; null if the address names no page. */
export function tornOff(search: string): string | null {
  return new URLSearchParams(search).get(OF);
}

/** Opens a secondary window, or brings it to the front; returns false if the browser blocked it. */
export function tearOff(what: Torn): boolean {
  const [name] = VIEWS.find(([, torn]) => torn === what) ?? VIEWS[0] ?? ['mon1'];
  const address = new URL(location.href);
  address.searchParams.set('view', name);
  address.searchParams.set(OF, pageName());
  return window.open(address, `aftdeck-${pageName()}-${name}`, 'popup,width=960,height=680') !== null;
}

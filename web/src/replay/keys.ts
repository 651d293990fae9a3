/** The keys of a replay, by their position on the keyboard. */

import type { Player } from './player';

/** Steps of the arrow keys and of Page up and down [s]. */
const SECOND = 1;
const PAGE = 10;

export interface ReplayKeys {
  event(by: 1 | -1): void;
  desk(): void;
  camera(index: number): void;
  stepCamera(by: 1 | -1): void;
  otherMonitor(): void;
  plane(): void;
  bending(): void;
  matrix(): void;
  split(): void;
  asFlown(): void;
  zoom(way: 1 | -1): void;
  close(): void;
}

/** Returns the action of a key; undefined for a key without an action. */
export function actionOf(player: Player, keys: ReplayKeys, event: Pick<KeyboardEvent, 'code' | 'shiftKey'>) {
  const digit = /^Digit([0-9])$/.exec(event.code)?.[1];
  if (digit) return () => keys.camera((Number(digit) + 9) % 10);
  const by = (seconds: number) => () => player.seek(player.position + seconds);
  const actions: Readonly<Record<string, () => void>> = {
    Space: () => player.toggle(),
    ArrowLeft: event.shiftKey ? () => player.step(-1) : by(-SECOND),
    ArrowRight: event.shiftKey ? () => player.step(1) : by(SECOND),
    PageUp: by(-PAGE),
    PageDown: by(PAGE),
    Home: () => player.seek(player.start),
    End: () => player.seek(player.duration),
    ArrowUp: () => player.faster(),
    ArrowDown: () => player.slower(),
    BracketLeft: () => keys.event(-1),
    BracketRight: () => keys.event(1),
    Comma: () => keys.stepCamera(-1),
    Period: () => keys.stepCamera(1),
    KeyX: () => keys.otherMonitor(),
    KeyD: () => keys.desk(),
    KeyF: () => keys.plane(),
    KeyB: () => keys.bending(),
    KeyC: () => keys.matrix(),
    KeyZ: () => keys.split(),
    KeyA: () => keys.asFlown(),
    Equal: () => keys.zoom(1),
    NumpadAdd: () => keys.zoom(1),
    Minus: () => keys.zoom(-1),
    NumpadSubtract: () => keys.zoom(-1),
    Escape: () => keys.close(),
  };
  return actions[event.code];
}

/** Starts listening to the keys. */
export function listen(player: Player, keys: ReplayKeys): void {
  const options = { capture: true };
  const down = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const act = actionOf(player, keys, event);
    if (!act) return;
    event.preventDefault();
    act();
  };
  // Space must only play or pause: its release would also click a button in focus.
  const up = (event: KeyboardEvent) => {
    if (event.code === 'Space') event.preventDefault();
  };
  window.addEventListener('keydown', down, options);
  window.addEventListener('keyup', up, options);
}

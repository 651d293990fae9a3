/**
 * Rows of keys: each row is one stop of Tab, and the arrow keys ← and → move the focus within it. A row takes an arrow
 * key only if no function of the arm is assigned to this key (`isOwn` in `input/keyboard.ts`).
 */

import { setAttribute } from '../panel/parts/dom';

/** The rows of the page, and the keys of a row. */
const ROWS =
  '.cameras, .monitor-keys, .lamps, .lamp-pairs, .rotary, .switch, .joint-rotary, .rail-keys, .choices-of-device';
const KEYS = ':scope > button, :scope > .drop-down > button';

/** Makes all rows within `root`; `signal` ends them. */
export function keyRows(root: HTMLElement, signal: AbortSignal): void {
  for (const row of root.querySelectorAll<HTMLElement>(ROWS)) keyRow(row, signal);
}

function keyRow(row: HTMLElement, signal: AbortSignal): void {
  const keys = () => [...row.querySelectorAll<HTMLButtonElement>(KEYS)];
  row.dataset['row'] = '';
  const update = () => {
    const [usable, focused] = [keys().filter(isUsable), document.activeElement];
    const stop = stopOf(usable, focused);
    for (const key of keys()) setAttribute(key, 'tabindex', key === stop ? '0' : '-1');
  };
  const changes = new MutationObserver(update);
  const attributeFilter = ['aria-pressed', 'disabled', 'hidden'];
  changes.observe(row, { subtree: true, childList: true, attributeFilter });
  signal.addEventListener('abort', () => changes.disconnect());
  row.addEventListener('focusin', update, { signal });
  row.addEventListener('focusout', update, { signal });
  row.addEventListener(
    'keydown',
    (event) => {
      const by = { ArrowLeft: -1, ArrowRight: 1 }[event.code];
      if (by === undefined || event.defaultPrevented) return;
      const usable = keys().filter((key) => isUsable(key) && key.checkVisibility());
      const at = usable.indexOf(event.target as HTMLButtonElement);
      if (at < 0) return;
      event.preventDefault();
      usable[(at + by + usable.length) % usable.length]?.focus();
    },
    { signal },
  );
  update();
}

/** Returns the key at which Tab stops: the key in focus, or else the pressed key, or else the first key. */
export function stopOf<K extends Pick<Element, 'getAttribute'>>(
  keys: readonly K[],
  focused: unknown,
): K | undefined {
  const pressed = keys.find((key) => key.getAttribute('aria-pressed') === 'true');
  return keys.find((key) => key === focused) ?? pressed ?? keys[0];
}

function isUsable(key: HTMLButtonElement): boolean {
  return !key.disabled && !key.hidden;
}

/** Events after which a browser does not report the release of a held key or pointer. */

/** Menus, dialogs and other windows then receive the release. */
const WINDOW = ['blur', 'pagehide', 'beforeprint', 'compositionstart', 'contextmenu', 'dragstart'];
/** On macOS, no key is reported as released while Meta (Cmd) is held. Alt and F10 give the keys to a menu bar. */
const KEYS: ReadonlySet<string> = new Set(['Meta', 'OS', 'Alt', 'F10']);

/** Calls `lost`, until `signal`, at each event after which releases may be lost. */
export function whenSwallowed(lost: () => void, signal: AbortSignal): void {
  const heard = (event: Event) => swallows(event) && lost();
  // Keys are heard first of all, the others last: the page may prevent a menu or a drag.
  const listened = [
    ...WINDOW.map((type) => [window, type, false] as const),
    ...['keydown', 'keyup'].map((type) => [window, type, true] as const),
    [document, 'visibilitychange', false] as const,
  ];
  for (const [target, type, capture] of listened) target.addEventListener(type, heard, { capture });
  signal.addEventListener('abort', () => {
    for (const [target, type, capture] of listened) target.removeEventListener(type, heard, { capture });
  });
}

function swallows(event: Event): boolean {
  if (event.type === 'visibilitychange') return document.hidden;
  if (!event.type.startsWith('key')) return !event.defaultPrevented;
  const { key, metaKey } = event as KeyboardEvent;
  return metaKey || KEYS.has(key);
}

/** Name of this page among those of one browser: the same after a reload, but another one in a copy of its tab. */

const KEY = 'aftdeck page';

let own: string | null = null;

/** The page's name. The browser stores it only during a reload, so that a duplicated page gets a name of its own. */
export function pageName(): string {
  if (own !== null) return own;
  const name = kept(() => sessionStorage.getItem(KEY)) ?? Math.random().toString(36).slice(2);
  own = name;
  const forget = () => kept(() => sessionStorage.removeItem(KEY));
  window.addEventListener('pagehide', () => kept(() => sessionStorage.setItem(KEY, name)));
  window.addEventListener('pageshow', forget);
  forget();
  return name;
}

/** Null also if storage is unavailable. */
function kept<T>(act: () => T): T | null {
  try {
    return act();
  } catch {
    return null;
  }
}

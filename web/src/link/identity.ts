/** Name that distinguishes this page from the browser's other pages. A reload keeps it; a copy of the tab does not. */

const KEY = 'aftdeck page';

let own: string | null = null;

/** Returns the page's name. The browser stores it only during a reload, so that a copy of the tab gets another name. */
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

/** Returns the result of `act`, or null if storage is unavailable. */
function kept<T>(act: () => T): T | null {
  try {
    return act();
  } catch {
    return null;
  }
}

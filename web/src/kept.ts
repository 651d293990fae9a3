/** What the browser keeps between visits; where it keeps nothing, it is kept for this visit alone. */

export type Keeper = Pick<Storage, 'getItem' | 'setItem'>;

export function keeper(): Keeper {
  const here = new Map<string, string>();
  return {
    getItem(key) {
      try {
        return localStorage.getItem(key) ?? here.get(key) ?? null;
      } catch {
        return here.get(key) ?? null;
      }
    },
    setItem(key, value) {
      here.set(key, value);
      try {
        localStorage.setItem(key, value);
      } catch {
        // a browser that keeps nothing forgets it with the page
      }
    },
  };
}

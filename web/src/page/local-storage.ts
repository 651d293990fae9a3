/** What the browser keeps between visits; with one that keeps nothing (private, blocked, full) all goes as if new. */

/** Whether the browser did it. */
function done(act: () => void): boolean {
  try {
    act();
    return true;
  } catch {
    return false;
  }
}

export const keeper = {
  getItem(key: string): string | null {
    let text: string | null = null;
    done(() => {
      text = localStorage.getItem(key);
    });
    return text;
  },
  /** Returns whether it is kept. */
  setItem: (key: string, value: string) => done(() => localStorage.setItem(key, value)),
  removeItem: (key: string) => done(() => localStorage.removeItem(key)),
};

export type Keeper = Pick<Storage, 'getItem' | 'setItem'>;

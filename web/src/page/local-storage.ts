/** Wrapper of localStorage: returns null or false if storage is unavailable (private mode, blocked, full). */

/** Returns whether `act` did not throw. */
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
  /** Returns whether the value was stored. */
  setItem: (key: string, value: string) => done(() => localStorage.setItem(key, value)),
  removeItem: (key: string) => done(() => localStorage.removeItem(key)),
};

export type Keeper = Pick<Storage, 'getItem' | 'setItem'>;

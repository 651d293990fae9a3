/** Stick directions in the station's words, with the key that gives them. */

import { keyOf } from '../input/layout';

/** `Way out: THC −Z` as `Way out: THC −Z (Q)`. */
export function withKeys(text: string): string {
  return text.replace(/\b(?:THC|RHC) ([+−])(\w+)/g, (told, sign: string, axis: string) => {
    const key = keyOf(`${sign === '+' ? '+' : '-'}${axis}`);
    return key === '' ? told : `${told} (${key})`;
  });
}

/** Stick directions in the station's words, with the key, button or end of an axis that gives them. */

import type { Names } from '../input/in-hand';

/** `Way out: THC −Z` as `Way out: THC −Z (Q)`. */
export function withHandles(text: string, names: Names): string {
  return text.replace(/\b(?:THC|RHC) ([+−])(\w+)/g, (told, sign: string, axis: string) => {
    const handle = names.short(`${sign === '+' ? '+' : '-'}${axis}`);
    return handle === '' ? told : `${told} (${handle})`;
  });
}

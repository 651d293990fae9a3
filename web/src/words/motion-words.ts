/** Texts of mechanisms in motion, with the time that they still need. */

import type { Motion } from '../link/protocol';

/** Beginning of the texts of the telescope, which the panel shows beside the joints. */
export const TELESCOPE = 'telescope';

/** Returns the motions with their remaining times; empty if there are none. */
export function motionWords(motions: readonly Motion[]): string {
  return motions.map(({ text, remaining_s }) => `${text}, ${Math.ceil(remaining_s)} s`).join('; ');
}

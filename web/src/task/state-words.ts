/** What a step's text says beside its own words: an inhibited arm, mechanisms in motion, and another mode. */

import type { Names } from '../input/active-device';
import type { Frame, Motion, Welcome } from '../link/protocol';
import { motionWords } from '../words/motion-words';
import { contactWays } from '../words/way-out';
import type { Piece } from './words';

/** `A contact inhibits the arm: THC −X (S) leads away.` if ARM INHIBIT is lit, else nothing. */
export function barred(
  { work, ways_out }: { readonly work: Pick<Frame['work'], 'arm_inhibit'> } & Pick<Frame, 'ways_out'>,
  joints: Welcome['joints'],
  names: Names,
): readonly Piece[] {
  if (!work.arm_inhibit) return [];
  const ways = contactWays(ways_out, joints, names);
  const out = ways.length > 0 ? `: ${ways.join(' or ')} leads away` : '';
  return [{ kind: 'text', text: `A contact inhibits the arm${out}. ` }];
}

/** `Now: latches open, 12 s.` while mechanisms move, else nothing. */
export function moving(motions: readonly Motion[]): readonly Piece[] {
  return motions.length === 0 ? [] : [{ kind: 'text', text: ` Now: ${motionWords(motions)}.` }];
}

/** `[Enter] for ORB LD.` */
export function modeHint(mode: string): readonly Piece[] {
  return [
    { kind: 'use', text: 'enter' },
    { kind: 'text', text: ` for ${mode}. ` },
  ];
}

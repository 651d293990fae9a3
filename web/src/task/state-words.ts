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

/** Time of a leg from which on the operator is offered RATE HOLD [s]. */
const LONG_S = 20;

/**
 * `This leg takes 40 s: [H] keeps the rate.` if the remaining motion takes long at the speed limit; how to end RATE HOLD
 * while it is on; else nothing. A text whose functions (`uses`) include RATE HOLD says both itself.
 */
export function rateHoldHint(
  {
    rate_hold,
    por_limits,
    display,
  }: Pick<Frame, 'rate_hold' | 'por_limits'> & {
    readonly display: Pick<Frame['display'], 'to_go'>;
  },
  uses: readonly string[],
): readonly Piece[] {
  if (uses.includes('rate hold')) return [];
  if (rate_hold)
    return [
      { kind: 'text', text: ' RATE HOLD keeps the rate: ' },
      { kind: 'use', text: 'stop' },
      { kind: 'text', text: ' ends it.' },
    ];
  const go = display.to_go;
  const seconds = go && go.shift.length > 0 && por_limits[0] > 0 ? go.distance / por_limits[0] : 0;
  if (seconds <= LONG_S) return [];
  return [
    { kind: 'text', text: ` This leg takes ${10 * Math.round(seconds / 10)} s or more: ` },
    { kind: 'use', text: 'rate hold' },
    { kind: 'text', text: ' keeps the rate while you let go.' },
  ];
}

/** `First press [Enter] for ORB LD.` */
export function modeHint(mode: string): readonly Piece[] {
  return [
    { kind: 'text', text: 'First press ' },
    { kind: 'use', text: 'enter' },
    { kind: 'text', text: ` for ${mode}. ` },
  ];
}

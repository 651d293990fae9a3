/** Text of an escape direction, with the key, button or axis direction that commands it. */

import type { Names } from '../input/active-device';
import type { JointInfo, WayOut } from '../link/protocol';

const AXES = { rotation: ['roll', 'pitch', 'yaw'], translation: ['X', 'Y', 'Z'] } as const;

/** `THC −Z (Q)`, `ORB UNL, RHC +roll (O)`, `SINGLE elbow pitch −`. If `joint` is empty, the joint is not named. */
export function wayOutText({ stick, axis, sign, position }: WayOut, joint: string, names: Names): string {
  switch (stick) {
    case 'translation':
    case 'rotation': {
      const name = AXES[stick][axis] ?? '';
      const handle = names.short(`${sign > 0 ? '+' : '-'}${name}`);
      const place = position === '' ? '' : `${position}, `;
      const controller = stick === 'rotation' ? 'RHC' : 'THC';
      return `${place}${controller} ${direction(sign)}${name}${handle === '' ? '' : ` (${handle})`}`;
    }
    case 'joint':
      return [position, joint, direction(sign)].filter((part) => part !== '').join(' ');
    case 'telescope':
      return `telescope ${sign > 0 ? 'longer' : 'shorter'}`;
  }
}

/** Returns the texts of the directions that lead out of contacts. */
export function contactWays(
  ways: readonly WayOut[],
  joints: readonly Pick<JointInfo, 'name'>[],
  names: Names,
): readonly string[] {
  return ways
    .filter(({ cause }) => cause === 'contact')
    .map((way) => wayOutText(way, spoken(joints[way.axis]?.name ?? ''), names));
}

/** Joint's name in words: `elbow pitch`. */
export function spoken(joint: string): string {
  return joint.replaceAll('_', ' ');
}

function direction(sign: number): string {
  return sign > 0 ? '+' : '−';
}

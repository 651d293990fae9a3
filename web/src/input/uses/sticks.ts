/** Functions that deflect an axis, as `AXES` names them. */

import { AXES } from '../deflection';
import type { Row, Use } from './use';

/** Keys of the left hand, which translate: three above three. */
export const LEFT_HAND: readonly Row[] = [
  { help: '−Z up', uses: [axis('-Z', 'THC −Z', 'KeyQ')] },
  { help: '+X fwd', uses: [axis('+X', 'THC +X', 'KeyW')] },
  { help: '+Z down', uses: [axis('+Z', 'THC +Z', 'KeyE')] },
  { help: '−Y left', uses: [axis('-Y', 'THC −Y', 'KeyA')] },
  { help: '−X aft', uses: [axis('-X', 'THC −X', 'KeyS')] },
  { help: '+Y right', uses: [axis('+Y', 'THC +Y', 'KeyD')] },
];

/** Keys of the right hand, which rotate: three above three. */
export const RIGHT_HAND: readonly Row[] = [
  { help: '−roll', uses: [axis('-roll', 'RHC −roll', 'KeyU')] },
  { help: '+pitch up', uses: [axis('+pitch', 'RHC +pitch', 'KeyI')] },
  { help: '+roll', uses: [axis('+roll', 'RHC +roll', 'KeyO')] },
  { help: '−yaw left', uses: [axis('-yaw', 'RHC −yaw', 'KeyJ')] },
  { help: '−pitch dn', uses: [axis('-pitch', 'RHC −pitch', 'KeyK')] },
  { help: '+yaw right', uses: [axis('+yaw', 'RHC +yaw', 'KeyL')] },
];

export const LENS: Row = {
  help: 'and opposites: pan, tilt, zoom',
  caps: ['-pan', '+tilt', '+zoom'],
  group: 'lens',
  uses: [
    axis('-pan', 'pan left', 'ArrowLeft'),
    axis('+pan', 'pan right', 'ArrowRight'),
    axis('-tilt', 'tilt down', 'ArrowDown'),
    axis('+tilt', 'tilt up', 'ArrowUp'),
    axis('-zoom', 'zoom out', 'PageDown'),
    axis('+zoom', 'zoom in', 'PageUp'),
  ],
};

export const TELESCOPE: Row = {
  help: 'telescope shorter, longer',
  has: ({ work }) => work.stand !== null,
  group: 'joints',
  uses: [axis('-telescope', 'telescope shorter', 'KeyN'), axis('+telescope', 'telescope longer', 'KeyY')],
};

function axis(name: `${'+' | '-'}${(typeof AXES)[number]}`, label: string, key: string): Use {
  const sign = name.startsWith('-') ? -1 : 1;
  return {
    name,
    label,
    keys: [key],
    does: { kind: 'axis', axis: (AXES as readonly string[]).indexOf(name.slice(1)), sign },
  };
}

/** The SRMS's end effector: the six flags of the panel, capture and release, and the switches of the manual mode. */

import type { Hand as HandState } from '../../link/protocol';
import { button, el, setLit, setPressed } from '../parts/dom';
import { holdButton } from '../parts/hold-button';
import type { Desk } from '../parts/part';
import { CLOSE_S, type Hand, OPEN_S } from './hand';

/** The flags as on the panel: the upper row belongs to a capture, the lower row to a release. */
const FLAGS = ['CAPTURE', 'CLOSE', 'RIGID', 'EXTEND', 'OPEN', 'DERIGID'] as const;

const MODES = [
  ['auto', 'Auto'],
  ['manual', 'Man'],
] as const;
const CARRIAGE = ['rigid', 'derigid'] as const;

export function snares(desk: Desk): Hand {
  const close = holdButton('Capture', 'close', CLOSE_S, () =>
    desk.send({ type: 'effector', switch: 'close' }),
  );
  const open = holdButton('Release', 'open', OPEN_S, () => desk.send({ type: 'effector', switch: 'open' }));
  const flags = FLAGS.map((name) => el('span', { class: 'flag' }, name));
  const modes = MODES.map(([mode, name]) =>
    button({}, [name], () => desk.send({ type: 'effector_mode', mode })),
  );
  let rigid: HandState['rigid'] = 'off';
  const carriage = CARRIAGE.map((way) =>
    button({ title: 'Move only the carriage; press again to stop it' }, [way], () =>
      desk.send({ type: 'rigid', rigid: rigid === way ? 'off' : way }),
    ),
  );
  const element = el(
    'div',
    { class: 'hand' },
    el('div', { class: 'flags', role: 'status', 'aria-label': 'End effector flags' }, ...flags),
    el('div', { class: 'grips' }, close.element, open.element),
    el(
      'div',
      { class: 'manual', 'data-calm': 'full' },
      el('div', { class: 'switch', role: 'group', 'aria-label': 'End effector mode' }, ...modes),
      el('div', { class: 'switch', role: 'group', 'aria-label': 'Man contr' }, ...carriage),
    ),
  );
  return {
    element,
    close,
    open,
    moves: () => false,
    bars(_, names) {
      close.tick(names);
      open.tick(names);
    },
    set(hand) {
      FLAGS.forEach((name, i) => {
        const flag = flags[i];
        if (flag) setLit(flag, hand.flags.includes(name));
      });
      rigid = hand.rigid;
      modes.forEach((key, i) => {
        setPressed(key, MODES[i]?.[0] === hand.mode);
      });
      carriage.forEach((key, i) => {
        setPressed(key, CARRIAGE[i] === hand.rigid);
        key.disabled = hand.mode === 'auto';
      });
    },
  };
}

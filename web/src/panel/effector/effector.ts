/** The end effector: its switches and flags, and the latches of a berth. The buttons act only after a hold. */

import type { GripAction } from '../../input/action';
import type { Display, Frame, PayloadInfo, Work } from '../../link/protocol';
import { fixed } from '../../words/format';
import { motionWords, TELESCOPE } from '../../words/motion-words';
import type { Units } from '../../words/units';
import { group, setAbout, setClass } from '../parts/dom';
import type { Desk, Part } from '../parts/part';
import { prong } from './prong';
import { seat } from './seat';
import { snares } from './snares';

export interface EffectorGroup extends Part {
  /** Called when a key or button of the end effector or of the latches is pressed or released. */
  grip(action: GripAction): void;
}

export function effectorGroup(desk: Desk): EffectorGroup {
  const { work } = desk.welcome;
  const hand = work.hand === 'prong' ? prong(desk) : snares(desk);
  const seats = work.seats.length > 0 && work.cargo.length > 0 ? seat(desk) : null;
  const element = group('effector', 'End effector', hand.element, ...(seats ? [seats.element] : []));
  element.classList.add(work.hand);
  let latest: Work | null = null;

  function grip({ grip: which, down, at }: GripAction): void {
    if (which === 'brakes') return; // the brakes are not in this group
    if (which === 'latch') {
      if (down) seats?.keyed().press(at);
      else seats?.lift(at);
      return;
    }
    if (!down) {
      hand[which].lift(at);
      return;
    }
    const moving = latest !== null && hand.moves(latest.hand);
    if (moving) desk.send({ type: 'effector', switch: 'stop' });
    // While the prong moves, a press stops it. The key of the other direction, if held, then reverses it.
    if (!moving || latest?.hand.switch !== which) hand[which].press(at);
  }

  return {
    element,
    grip,
    bars({ frame, controllers: { names } }) {
      latest = frame.work;
      hand.bars(frame.work.hand, names);
      seats?.tick(names);
    },
    values({ frame, units }) {
      hand.set(frame.work.hand, units);
      seats?.set(frame.work);
      const motions = frame.motions.filter(({ text }) => !text.startsWith(TELESCOPE));
      setClass(element, 'busy', motions.length > 0);
      setAbout(element, motionWords(motions) || graspWords(frame, desk.welcome.payloads, units));
    },
  };
}

/** Returns the name of the held payload, its mass and the speed limit of its POR; `empty`, and the tip's, if none is held. */
export function graspWords(
  {
    work: { cargo },
    display: { payload_id },
    rate,
  }: Pick<Frame, 'rate'> & {
    readonly work: Pick<Work, 'cargo'>;
    readonly display: Pick<Display, 'payload_id'>;
  },
  payloads: readonly Pick<PayloadInfo, 'id' | 'mass' | 'translation'>[],
  { mass, speed }: Pick<Units, 'mass' | 'speed'>,
): string {
  const held = cargo.find((each) => each.held);
  if (!held && cargo.length === 0) return '';
  const name = held?.name ?? 'empty';
  const its = payloads.find(({ id }) => id === payload_id);
  if (!its) return name;
  const fast = its.translation[rate === 'coarse' ? 0 : 1] * speed.perSi;
  const most = `max ${fixed(fast, speed.decimals, false)} ${speed.name}`;
  if (!held) return `${name}, ${most}`;
  return `${name}, ${fixed(its.mass * mass.perSi, mass.decimals, false)} ${mass.name}, ${most}`;
}

/** Groups of the desk, live and in a replay: their order, and which groups are visible in each mode. */

import type { GripAction } from '../../input/action';
import { clearanceGroup } from '../clearance/clearance';
import { conditionsGroup } from '../clearance/conditions';
import { cargoGroup } from '../effector/cargo';
import { effectorGroup } from '../effector/effector';
import { joints } from '../joints/joints';
import { masterGroup } from '../joints/master';
import { button, el, setAttribute, setClass } from '../parts/dom';
import type { Desk, View } from '../parts/part';
import { type TargetGroup, targetGroup } from '../target/target';
import { brakesSafing } from './brakes-safing';
import type { EventsGroup } from './events';
import { limits } from './limits';
import { lookAhead } from './look-ahead';
import { type ModeGroup, modeGroup } from './mode';
import { resolution } from './resolution';
import { rhc } from './rhc';
import { singularity } from './singularity';
import { thc } from './thc';

export interface DeskListener {
  /** Assigns the THC to the orbiter, or to the arm. */
  flyOrbiter(on: boolean): void;
  /** Switches PULSE on or off; undefined in a replay. */
  pulse?(): void;
  /** Shows the last minutes as strips in a secondary window; undefined in a replay. */
  strips?(): void;
}

export interface Groups {
  /** The groups in the order in which the focus moves: the upper row from the left, then the lower row. */
  readonly elements: readonly HTMLElement[];
  readonly mode: ModeGroup;
  readonly target: TargetGroup;
  setPlane(on: boolean): void;
  setBending(on: boolean): void;
  grip(action: GripAction): void;
  /** Sets the master arm to the arm's angles. */
  meetMaster(): void;
  bars(view: View): void;
  values(view: View): void;
}

export function deskGroups(desk: Desk, events: EventsGroup, listener: DeskListener): Groups {
  const target = targetGroup(desk);
  const master = masterGroup(desk);
  const mode = modeGroup(desk);
  const clearance = clearanceGroup(desk);
  const { strips } = listener;
  if (strips) clearance.element.querySelector('h2 .about')?.after(stripsKey(strips));
  const effector = effectorGroup(desk);
  effector.element.querySelector('h2')?.append(pageKey(() => desk.act('control page')));
  const [acting, cargo, conditions] = [limits(desk), cargoGroup(desk), conditionsGroup()];
  const ahead = lookAhead(desk);
  const resting = el('div', { class: 'resting' }, acting.element, cargo.element);
  const still = brakesSafing(desk);
  const [sticks, turns] = [thc(desk, (on) => listener.flyOrbiter(on), listener.pulse), rhc()];
  const own = joints(desk);
  const upper = [sticks, mode, resolution(desk), own, master, clearance, target, turns];
  const last = singularity(desk);
  const parts = [...upper, still, effector, acting, cargo, ahead, conditions, last];
  const row = el(
    'div',
    { class: 'lower' },
    events.element,
    effector.element,
    resting,
    conditions.element,
    ahead.element,
    last.element,
  );
  const elements = [...upper.map(({ element }) => element), still.element, row];
  for (const [{ element }, need] of [
    [own, 'joints'],
    [effector, 'effector'],
    [acting, 'limits'],
    [cargo, 'full'],
    [ahead, 'look ahead'],
    [last, 'singularity'],
  ] as const)
    setAttribute(element, 'data-calm', need);
  cargo.element.hidden = desk.welcome.work.cargo.length === 0;
  setClass(resting, 'alone', cargo.element.hidden);

  /** Shows the groups that the present mode and objective need, and hides the others. */
  function arrange(view: View): void {
    const kind = (position: string) => desk.welcome.modes.find((each) => each.position === position)?.kind;
    const entered = kind(view.frame.mode);
    const automatic = entered === 'automatic' || mode.inView()?.kind === 'automatic';
    target.element.hidden = !automatic;
    turns.element.hidden = automatic;
    setClass(clearance.element, 'narrow', automatic);
    master.element.hidden = entered !== 'master';
    own.element.hidden = entered === 'master';
    const pursuing = view.frame.work.conditions.length > 0;
    conditions.element.hidden = !pursuing;
    setClass(ahead.element, 'brief', pursuing);
    resting.hidden = pursuing;
  }

  return {
    elements,
    mode,
    target,
    setPlane: (on) => clearance.setPlane(on),
    setBending: (on) => own.setBending(on),
    grip: (action) => (action.grip === 'brakes' ? still : effector).grip(action),
    meetMaster: () => master.meet(),
    bars(view) {
      for (const part of parts) part.bars?.(view);
    },
    values(view) {
      for (const part of parts) part.values?.(view);
      arrange(view);
    },
  };
}

function pageKey(pressed: () => void): HTMLElement {
  return button(
    {
      class: 'more',
      'data-calm': 'control page',
      title: 'Open PDRS control (SPEC 94): target, stored points, payloads',
    },
    ['SPEC 94'],
    pressed,
  );
}

function stripsKey(pressed: () => void): HTMLElement {
  const title = 'Open strips of the last minutes in a secondary window';
  return button(
    { class: 'more', title, 'aria-label': 'Strips ↗', 'data-calm': 'full' },
    [el('span', {}, 'Strips '), '↗'],
    pressed,
  );
}

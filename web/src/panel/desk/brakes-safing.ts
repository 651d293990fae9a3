/** BRAKES, SAFING and POSITION HOLD, and above them the name of the device or operator that moves the sticks. */

import type { GripAction } from '../../input/action';
import { el, setAttribute, setClass, setPressed, setText } from '../parts/dom';
import { holdButton } from '../parts/hold-button';
import type { Desk, View } from '../parts/part';
import { switchButton } from '../parts/switch-button';

/** Time for which the switch must be held to release the brakes [s]. To set them, a press is sufficient. */
const OFF_S = 0.5;

export interface BrakesSafing {
  readonly element: HTMLElement;
  /** Called when the key or button of the brakes is pressed or released. */
  grip(action: GripAction): void;
  bars(view: View): void;
  values(view: View): void;
}

export function brakesSafing(desk: Desk): BrakesSafing {
  let on = false;
  const release = () => desk.send({ type: 'brakes', on: false });
  const brakes = holdButton('Brakes', 'brakes', OFF_S, release, () => {
    if (!on) desk.send({ type: 'brakes', on: true });
    return on;
  });
  const safing = switchButton(desk, 'safing', {
    kind: 'safing',
    label: 'Safing',
    title: 'Command zero joint rates until cancelled',
  });
  const positionHold = switchButton(desk, 'position hold', {
    kind: 'hold',
    label: 'Pos hold',
    title: 'Hold position and attitude while the sticks are centred',
  });
  setAttribute(brakes.element, 'data-calm', 'brakes');
  const device = el('p', { class: 'device' });
  return {
    element: el('div', { class: 'standing' }, device, brakes.element, safing.element, positionHold.element),
    grip({ down, at }) {
      if (down) brakes.press(at);
      else brakes.lift(at);
    },
    bars: ({ controllers }) => brakes.tick(controllers.names),
    values({ frame, flying, flier, controllers }) {
      const lost = controllers.gone.thc ?? controllers.gone.rhc;
      const moved = frame.display.autopilot === null ? controllers.words : 'Move a stick to take over';
      const words = !flying ? flown(flier) : lost === null ? moved : `✕ ${lost} lost`;
      setText(device, words);
      setAttribute(device, 'title', words);
      setClass(device, 'lost', flying && lost !== null);
      on = frame.brakes;
      setPressed(brakes.element, on);
      safing.set(frame.safing, controllers.names);
      positionHold.set(frame.position_hold, controllers.names);
      setClass(brakes.element, 'caution', on);
      setClass(safing.element, 'caution', frame.safing);
      setAttribute(
        brakes.element,
        'title',
        on ? `Hold ${OFF_S} s to release` : 'Set the brakes on all joints',
      );
    },
  };
}

/** Returns a sentence that names the operator; empty in a replay, because a recording does not contain the name. */
const flown = (flier: string | null) =>
  flier === '' ? 'Unattended' : flier === null ? '' : `${flier} flies`;

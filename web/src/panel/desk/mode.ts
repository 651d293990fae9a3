/** The MODE rotary with ENTER, and the switches of the selected mode. */

import type { ModeInfo } from '../../link/protocol';
import { group, setAbout, setClass } from '../parts/dom';
import type { Desk, Part } from '../parts/part';
import { rotary } from './rotary';
import { switches } from './switches';

export interface ModeGroup extends Part {
  /** Turns the rotary by one position, without entering the mode. */
  turn(by: number): void;
  /** Enters the selected position; returns whether one was selected. */
  enter(): boolean;
  /** Turns the JOINT rotary by one joint. */
  turnJoint(by: number): void;
  /** The selected position, or the entered position if none is selected. */
  inView(): ModeInfo | undefined;
}

export function modeGroup(desk: Desk): ModeGroup {
  const positions = rotary(desk);
  const below = switches(desk);
  const element = group('mode', 'Mode', positions.element, below.element);
  const infoOf = (name: string) => desk.welcome.modes.find(({ position }) => position === name);
  return {
    element,
    values({ frame }) {
      positions.set(frame.mode, frame.display.payload_id !== 0);
      const shown = positions.shown();
      setAbout(element, shown === frame.mode ? 'entered' : `Enter sets ${shown}`);
      setClass(element, 'single', infoOf(frame.mode)?.kind === 'single');
      below.set(frame, infoOf(shown));
    },
    turn: positions.turn,
    enter: positions.enter,
    turnJoint: below.turnJoint,
    inView: () => infoOf(positions.shown()),
  };
}

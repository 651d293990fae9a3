/** The desk as it was during the run: its groups, drawn from recorded frames. Their controls have no effect. */

import { NO_CONTROLLERS } from '../input/controllers';
import type { Frame, PlaybackIndex } from '../link/protocol';
import { deskGroups, type Groups } from '../panel/desk/desk';
import { EventsGroup } from '../panel/desk/events';
import { el } from '../panel/parts/dom';
import type { Desk, View } from '../panel/parts/part';
import { lightSegments } from '../panel/spine/lamp-test';
import type { Units } from '../words/units';

export class FlownDesk {
  readonly element: HTMLElement;
  private readonly groups: Groups;
  private readonly events = new EventsGroup([]);
  private past = 0;

  constructor(private readonly index: PlaybackIndex) {
    const desk: Desk = { welcome: index.welcome, send() {}, act() {}, say() {} };
    this.groups = deskGroups(desk, this.events, { flyOrbiter() {} });
    this.element = el(
      'section',
      { class: 'desk', 'aria-label': 'Desk of the recorded run', inert: '' },
      ...this.groups.elements,
    );
  }

  setBending(on: boolean): void {
    this.groups.setBending(on);
  }

  setPlane(on: boolean): void {
    this.groups.setPlane(on);
  }

  bars(frame: Frame, units: Units): void {
    this.groups.bars(viewOf(frame, units));
  }

  /** `past`: number of events up to the playhead. */
  values(frame: Frame, units: Units, past: number): void {
    this.groups.values(viewOf(frame, units));
    if (frame.mode === 'TEST') lightSegments();
    if (past === this.past) return;
    if (past < this.past) this.events.clear();
    this.events.add(this.index.events.slice(past < this.past ? 0 : this.past, past));
    this.past = past;
  }
}

function viewOf(frame: Frame, units: Units): View {
  const [x, y, z] = frame.translation;
  const [roll, pitch, yaw] = frame.rotation;
  const hand = [x, y, z, roll, pitch, yaw, 0];
  return { frame, units, hand, controllers: NO_CONTROLLERS, flying: false, orbiting: false, flier: null };
}

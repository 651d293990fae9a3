/** The desk as it was flown: the same groups, drawn from the recorded frame, and nothing to operate. */

import { Pad } from '../input/gamepad';
import { el } from '../panel/dom';
import { EventsGroup } from '../panel/events';
import { joints } from '../panel/joints';
import { lightSegments } from '../panel/lamp-test';
import { limits } from '../panel/limits';
import { modeGroup } from '../panel/mode';
import type { Desk, Part, View } from '../panel/part';
import { resolution } from '../panel/resolution';
import { rhc } from '../panel/rhc';
import { singularity } from '../panel/singularity';
import { targetGroup } from '../panel/target';
import { thc } from '../panel/thc';
import type { Frame, PlaybackIndex } from '../protocol';
import type { Units } from '../units';

export class FlownDesk {
  readonly element: HTMLElement;
  private readonly parts: readonly Part[];
  private readonly events = new EventsGroup([]);
  private past = 0;

  constructor(private readonly index: PlaybackIndex) {
    const desk: Desk = { welcome: index.welcome, send() {}, say() {} };
    const pad = new Pad(() => {});
    this.parts = [
      thc(desk),
      modeGroup(desk, () => {}),
      resolution(desk),
      joints(desk),
      targetGroup(desk),
      rhc(desk, pad),
      { element: this.events.element },
      limits(desk),
      singularity(),
    ];
    this.element = el(
      'section',
      { class: 'desk', 'aria-label': 'Desk as flown', inert: '' },
      ...this.parts.map(({ element }) => element),
    );
  }

  bars(frame: Frame, units: Units): void {
    const view = viewOf(frame, units);
    for (const part of this.parts) part.bars?.(view);
  }

  /** `past`: how many events lie behind the playhead. */
  values(frame: Frame, units: Units, past: number): void {
    const view = viewOf(frame, units);
    for (const part of this.parts) part.values?.(view);
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
  return { frame, units, hand: [x, y, z, roll, pitch, yaw], flying: false };
}

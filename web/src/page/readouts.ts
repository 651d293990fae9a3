/** Shows a frame outside the desk and the pictures: marks, numbers, lamps and sounds. */

import type { Frame, Lamp } from '../link/protocol';
import { clearanceCause } from '../panel/clearance/clearance';
import type { View } from '../panel/parts/part';
import type { Delays } from '../panel/rail/delays';
import { calledFirst } from '../panel/rail/operator-name';
import type { Measured } from '../panel/rail/rail';
import { lightSegments } from '../panel/spine/lamp-test';
import type { SpineLamp } from '../panel/spine/lamps';
import { ownLamps } from '../panel/spine/own-lamps';
import type { Drawn } from './draw-loop';
import type { Parts } from './parts';

export class Readouts implements Drawn {
  readonly pictures;
  readonly groups;

  constructor(private readonly parts: Parts) {
    this.pictures = parts.pictures;
    this.groups = parts.groups;
  }

  viewOf(frame: Frame): View {
    const { units, operator, control } = this.parts;
    return {
      frame,
      units: units.units,
      hand: operator.sticks.value,
      controllers: operator.controllers.shown,
      flier: calledFirst(control.role, control.role.flier),
      flying: control.role.flying,
      orbiting: operator.sticks.flyingOrbiter && control.role.flying,
    };
  }

  bars(): void {
    const { keys, operator, sheet, touch, task } = this.parts;
    keys.light(operator.controllers.keyboard.held);
    sheet.tick();
    touch.draw();
    task.light();
  }

  values(view: View, measured: Measured, now: number): void {
    const { parts } = this;
    const { role, link } = parts.control;
    const test = view.frame.mode === 'TEST';
    parts.controlPage.values(view);
    const lamps = [...inUnits(view), ...this.ownLamps(measured.delays, now)];
    parts.spine.show(lamps, test, view.controllers.names);
    parts.task.values(view);
    parts.opening.values(view, parts.control.tooNarrow, role.may_fly);
    parts.calm.values(view, {
      lamps: lamps.filter(({ level, standing }) => level !== 'info' && !standing).map(({ name }) => name),
      selected: parts.groups.mode.inView(),
      cameras: parts.pictures.monitors.shown.flat(),
    });
    parts.rail.values(view, measured, parts.handOver.words(role, now), link);
    parts.sounds.update(view.frame);
    if (role.flying) parts.report.update(measured.picture, parts.pictures.monitors.shown, now);
    if (test) lightSegments();
  }

  private ownLamps(delays: Delays, now: number): readonly SpineLamp[] {
    const { control, operator, arrivals, freshness, log } = this.parts;
    const controllers = control.tooNarrow ? null : operator.controllers;
    const [silence, { pictures }] = [arrivals.silence(now), freshness];
    return ownLamps({ refusedAt: log.refusedAt, silence, delays, pictures, controllers }, now);
  }
}

/** Returns the frame's lamps. The text of CLEARANCE contains the minimum clearance in the operator's units. */
export function inUnits({ frame, units }: Pick<View, 'frame' | 'units'>): readonly Lamp[] {
  const { nearest } = frame.work;
  return frame.display.lamps.map((lamp) =>
    lamp.name === 'CLEARANCE' && nearest ? { ...lamp, text: clearanceCause(nearest, units) } : lamp,
  );
}

/** Sounds of a frame: alarms until they are acknowledged, clicks at modes and captures, motors and mechanisms in motion. */

import type { Frame } from '../link/protocol';
import type { Spine } from '../panel/spine/spine';
import type { Tones } from './tones';

export class Sounds {
  private before: { readonly mode: string; readonly held: number } | null = null;

  constructor(
    private readonly tones: Tones,
    private readonly spine: Spine,
  ) {}

  update(frame: Frame): void {
    const { alarm, more } = this.spine.takeAlarm();
    this.tones.sound(alarm, more);
    this.spine.setMuted(this.tones.muted);
    const parts = frame.rates.map((rate, joint) => Math.abs(rate) / (frame.rate_limits[joint] ?? 1));
    this.tones.moving(Math.max(...parts), frame.motions.length > 0);
    const now = { mode: frame.mode, held: frame.work.cargo.filter(({ held }) => held).length };
    if (this.before && now.mode !== this.before.mode) this.tones.entered();
    if (this.before && now.held > this.before.held) this.tones.captured();
    this.before = now;
  }
}

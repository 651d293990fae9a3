/** Bends the drawn arm: as the simulation bends it, or exaggerated. */

import { Matrix4 } from 'three';
import type { FlexureInfo, Welcome } from '../link/protocol';
import { type Bend, motionOf, times } from './bend';
import type { Body } from './bodies';

/** Factor by which the page exaggerates bending. */
export const EXAGGERATION = 50;

export class Bending {
  private readonly parts: readonly FlexureInfo[];
  /** Indices of the arm's bodies, from base to tip. */
  private readonly arm: readonly number[];

  constructor(
    { flexures, ghost, work }: Pick<Welcome, 'flexures' | 'ghost' | 'work'>,
    private readonly bodies: readonly Body[],
  ) {
    this.parts = flexures;
    this.arm = ghost.slice(0, ghost.length - work.cargo.length);
  }

  /**
   * Bends the booms. Called after the poses are set, which contain the bends already.
   *
   * @param bends bend of each part; none if nothing bends.
   * @param factor 1, or `EXAGGERATION`.
   * @param held names of the payloads that the arm holds: they move with its tip.
   */
  show(bends: readonly Bend[], factor: number, held: readonly string[]): void {
    if (bends.length !== this.parts.length) return;
    const exaggerated = bends.map((bend) => times(bend, factor));
    // The outermost part first: the bodies before it have their true poses still.
    for (let n = bends.length - 1; n >= 0; n--) {
      const [part, bend, more] = [this.parts[n], bends[n], exaggerated[n]];
      const carrier = part && this.bodies[part.body];
      if (!carrier || !bend || !more) continue;
      if (Math.hypot(...part.end) > 0) carrier.bend(part.end, more);
      if (factor === 1) continue;
      const frame = carrier.group.matrix;
      const extra = motionOf(more, part.end).multiply(motionOf(bend, part.end).invert());
      const motion = new Matrix4().copy(frame).multiply(extra).multiply(new Matrix4().copy(frame).invert());
      this.bodies.forEach((body, i) => {
        const behind = i > part.body && this.arm.includes(i);
        if (behind || held.includes(body.group.name)) body.move(motion);
      });
    }
  }
}

/**
 * Chooses how finely the pictures are drawn. In the low profile without a graphics card, moving pictures are as fine as
 * their speed allows, and still ones are as sharp as the screen. Otherwise all pictures are.
 */

import type { ClosestPoints, Frame } from '../link/protocol';
import type { Scene } from '../scene';
import type { View } from '../scene/drawn';
import { SAMPLES } from '../scene/samples';
import { Resolution } from './resolution';
import { LEAST, Rest } from './rest';
import { Still } from './still';

/** Resolution of pictures, as a share of the screen's, and number of samples of each of their pixels. */
export interface Sharpness {
  readonly scale: number;
  readonly samples: number;
}

/** Least change of an exposure that counts [stops]: an exposure approaches its value for seconds. */
const LEAST_STOPS = 0.1;

export class Fineness {
  /** Sharpness of the pictures on the page; null if all are as sharp as the screen, and before the first pictures. */
  sharpness: Sharpness | null = null;
  private readonly resolution = new Resolution();
  private readonly rest = new Rest();
  private readonly still = new Still();
  private rests = false;
  private drawn: Sharpness | null = null;
  /** Area of the moving pictures that were drawn last [CSS px]. */
  private area = 0;
  /** When these were on the page [ms]; null if the last turn drew no moving pictures. */
  private turnAt: number | null = null;

  /**
   * Compares at `now` [ms] what the pictures show with before. Returns a text that changes with it.
   *
   * @param stops exposures of the pictures [stops].
   * @param state text that changes with everything else in the pictures.
   */
  look(
    frame: Frame,
    gap: ClosestPoints | null,
    stops: readonly number[],
    state: string,
    now: number,
  ): string {
    const exposures = stops.map((stop) => stop * (LEAST / LEAST_STOPS));
    this.rests = this.rest.look([...numbersOf(frame, gap), ...exposures], state, now);
    return `${this.rest.changes}`;
  }

  /** Begins the still pictures again: the page has lost their pixels. */
  forget(): void {
    this.still.forget();
  }

  /**
   * Draws the pictures that are due, or the next parts of still ones if none is due. Returns whether the pictures have
   * their final sharpness.
   *
   * @param state text that `look` has returned.
   * @param views all pictures; a later one covers an earlier one.
   * @param lively whether the pictures change even if nothing moves: they have noise, or show frames of their own.
   * @param stage sets the scene to the frame of a picture that is not still.
   */
  draw(
    scene: Scene,
    state: string,
    due: readonly View[],
    views: readonly View[],
    lively: boolean,
    stage: (view: View) => void,
  ): boolean {
    if (!scene.refines) {
      scene.draw(due, 1, stage);
      return true;
    }
    this.area = due.reduce((sum, { rect: { width, height } }) => sum + width * height, 0);
    if (due.length > 0) {
      const { scale } = this.resolution;
      scene.draw(due, scale, stage);
      this.drawn = { scale, samples: 1 };
      return lively;
    }
    if (lively || !this.rests) return lively;
    const pieces = this.still.next(state, views, this.resolution.most);
    scene.refine(pieces, this.still.done);
    if (this.still.done) this.drawn = { scale: 1, samples: SAMPLES.length };
    return this.still.done;
  }

  /** Called at `now` [ms] when the pictures are on the page, whose drawing began at `begun` [ms]. */
  shown(begun: number, now: number): void {
    this.sharpness = this.drawn;
    // Turns count only if they follow each other: before, the page may have waited for something to change.
    const before = this.turnAt;
    this.turnAt = this.area > 0 ? now : null;
    if (before !== null && this.turnAt !== null)
      this.resolution.took({ period: now - before, drawing: now - begun, area: this.area }, now);
  }
}

/** Numbers of a frame that its pictures show. */
function numbersOf({ display, views, dynamics }: Frame, gap: ClosestPoints | null): readonly number[] {
  const line = gap ? [...gap.point_a, ...gap.point_b] : [];
  const bends = dynamics?.bends.flatMap(({ displacement, rotation }) => [...displacement, ...rotation]) ?? [];
  return [...display.poses, ...views.flat(), ...line, ...(display.to_go?.shift ?? []), ...bends];
}

/** Sets the scene to the frames that the pictures show. */

import type { ClosestPoints, Frame } from '../link/protocol';
import { FARTHEST } from '../panel/clearance/gap-scale';
import type { Scene } from '../scene';
import type { Subject } from './best-pair';
import type { Survey } from './coverage';

/** Colours of the line of minimum clearance, equal to `--caution` and `--ink` in the style sheets. */
const [CAUTION, CALM] = ['#ffb534', '#d9dbdc'];

/** How frames are drawn. */
export interface Manner {
  /** Whether bending is drawn exaggerated. */
  readonly exaggerated: boolean;
  /** Whether the separating plane is drawn. */
  readonly plane: boolean;
  /** Centre of the engineering views; null for their initial centre. */
  readonly round: Subject | null;
}

export class Staging {
  /** The frame to which the scene is set. */
  private frame: Frame | null = null;

  constructor(
    private readonly scene: Scene,
    private readonly survey: Survey,
  ) {}

  /** Sets the scene to a frame, except its light; `now`: the time with which ghosts fade [ms]. */
  set(frame: Frame, { exaggerated, plane, round }: Manner, now: number | null): void {
    const { scene, survey } = this;
    this.frame = frame;
    const gap = drawnGap(frame);
    scene.setPoses(frame, exaggerated, now);
    scene.cameras.put(frame.views);
    const centre = round && survey.place(round, frame, gap);
    if (centre) scene.cameras.follow(centre);
    scene.setGap(gap, isCaution(frame) ? CAUTION : CALM, plane);
    const { ahead } = frame.display;
    scene.setGhost(ahead?.held && ahead.moves ? ahead.poses : null, now);
  }

  /** Sets the scene to another frame of the same drawing of the page. */
  change(frame: Frame, manner: Manner): void {
    if (frame !== this.frame) this.set(frame, manner, null);
  }
}

/** Whether the minimum clearance of a frame is a caution. */
export function isCaution({ work }: Frame): boolean {
  return work.clearance_level !== 'info';
}

/** Returns the minimum clearance to draw as a line; null if it is large, or if the parts are in contact. */
export function drawnGap({ work: { nearest }, display: { gap } }: Frame): ClosestPoints | null {
  return nearest && nearest.clearance > 0 && nearest.clearance < FARTHEST ? gap : null;
}

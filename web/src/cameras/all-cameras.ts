/** Updates the view of all cameras: the subjects that each one sees, the best pair, and the plan of their positions. */

import type { Camera, ClosestPoints, Frame } from '../link/protocol';
import type { Matrix } from '../panel/monitors/matrix';
import { extentOf } from '../panel/monitors/plan';
import type { Scene } from '../scene';
import type { Rect } from '../scene/drawn';
import { pairWords, type Survey } from './coverage';

/** One camera is surveyed at every `SURVEYED`-th drawing of the page. */
const SURVEYED = 3;

/** A monitor's label and cameras. */
export interface Showing {
  readonly label: string;
  readonly cameras: readonly Camera[];
}

/** State of the page while all cameras are shown. */
export interface Drawn {
  readonly frame: Frame;
  readonly gap: ClosestPoints | null;
  readonly monitors: readonly Showing[];
  /** Number of drawings of the page so far. */
  readonly count: number;
  /** Whether everything must be drawn again. */
  readonly wiped: boolean;
}

export class AllCameras {
  private readonly televised: readonly Camera[];

  /** `pace`: the plan is drawn at every `pace`-th drawing of the page. */
  constructor(
    private readonly matrix: Matrix,
    private readonly scene: Scene,
    private readonly survey: Survey,
    private readonly cameras: readonly Camera[],
    private readonly pace: number,
  ) {
    this.televised = cameras.filter(({ kind }) => kind === 'camera');
  }

  /** @param rectOf position of an element on the canvas. */
  show(drawn: Drawn, rectOf: (element: HTMLElement) => Rect): void {
    const { frame, gap, monitors, count, wiped } = drawn;
    const { matrix, survey } = this;
    if (wiped) survey.lookAll(frame, gap);
    else if (count % SURVEYED === 0) survey.look(frame, gap, 1);
    this.cameras.forEach((camera, i) => {
      const tags = monitors.filter(({ cameras }) => cameras.includes(camera));
      matrix.say(
        i,
        survey.sees(camera),
        tags.map(({ label }) => label),
      );
    });
    matrix.setAdvice(pairWords(survey.best()));
    if (count % this.pace === 0 || wiped) this.drawPlan(drawn, rectOf);
  }

  private drawPlan({ gap, monitors }: Drawn, rectOf: (element: HTMLElement) => Rect): void {
    const { plan } = this.matrix;
    if (!plan.picture.isConnected) return;
    const rect = rectOf(plan.picture);
    if (rect.width < 1 || rect.height < 1) return;
    const { scene } = this;
    const used = monitors.flatMap(({ cameras }) => cameras);
    const marks = this.televised.map((camera) => ({
      camera,
      lens: scene.sight.lens(camera),
      ahead: scene.sight.direction(camera),
      angle: scene.cameras.setting(camera.name)[2],
      used: used.includes(camera),
    }));
    const extent = extentOf([...marks.map(({ lens }) => lens), ...this.survey.places], rect);
    plan.set(extent, marks, gap?.plane ?? null);
    scene.drawPlan(rect, extent);
  }
}

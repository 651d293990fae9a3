/** Offers a pair of cameras: the best pair after each change of situation, and the pair of a step of the task. */

import type { ClosestPoints, Frame, Welcome } from '../link/protocol';
import type { Survey } from './coverage';
import type { Monitors } from './monitors';
import { type PairOffer, SituationWatch, situationOf, situationWords } from './pair-offer';

export class Offers {
  private readonly watch: SituationWatch;
  private present: PairOffer | null = null;
  /** Whether the next offer is shown at once, because the run starts again at a task phase. */
  private reopening = false;

  /** `changed` is called when another pair is offered, or with null when the offer ends. */
  constructor(
    private readonly welcome: Pick<Welcome, 'cameras' | 'steps'>,
    private readonly monitors: Pick<Monitors, 'show' | 'shown'>,
    private readonly changed: (offer: PairOffer | null) => void,
  ) {
    this.watch = new SituationWatch(welcome.cameras.length);
  }

  /** Offers a pair of cameras, unless the monitors show it already; null ends an offer. */
  offer(offer: PairOffer | null): void {
    const shown = this.monitors.shown.map((names) => names.join());
    const known = offer?.cameras.every((name) => shown.includes(name)) === true;
    this.present = known ? null : offer;
    this.changed(this.present);
  }

  /** Shows the offered pair on the monitors. */
  take(): void {
    this.present?.cameras.forEach((name, i) => {
      this.monitors.show(i, [name]);
    });
    this.offer(null);
  }

  /** Shows the best pair as soon as the situation has changed, because the run starts again at a task phase. */
  reopen(): void {
    this.reopening = true;
  }

  /** After a change of situation, surveys one camera at each drawing, and then offers the best pair. */
  look(frame: Frame, gap: ClosestPoints | null, survey: Survey): void {
    const { watch } = this;
    watch.see(situationOf(frame, gap));
    if (!watch.pending) return;
    survey.look(frame, gap, 1);
    if (!watch.surveyed()) return;
    if (this.reopening) survey.open(frame, gap);
    const [first, second] = survey.first(frame);
    if (first && second && !this.stepHasCameras(frame))
      this.offer({ cameras: [first.name, second.name], why: situationWords(frame) });
    if (this.reopening) this.take();
    this.reopening = false;
  }

  /** Whether the present step of the task names its own cameras, which the page offers when the step begins. */
  private stepHasCameras({ display: { task } }: Frame): boolean {
    return (this.welcome.steps[task?.at ?? -1]?.cameras.length ?? 0) > 0;
  }
}

/** When pictures, bars and figures are drawn, and from which frame: pictures first, figures ten times a second. */

import type { Pictures } from '../cameras/pictures';
import { isStale, type Seen } from '../link/delay-line';
import type { Arrivals } from '../link/delayed-messages';
import type { Latency } from '../link/latency';
import type { Frame, ModeInfo, Welcome } from '../link/protocol';
import type { Groups } from '../panel/desk/desk';
import { setClass } from '../panel/parts/dom';
import type { View } from '../panel/parts/part';
import type { Measured } from '../panel/rail/rail';
import type { Operator } from './operator';

/** Time between two updates of figures and legends [ms]. */
const VALUES_MS = 100;
/** Longest time that they wait for a picture [ms]. */
const OVERDUE_MS = 300;

/** The parts of the page that the loop draws. */
export interface Drawn {
  readonly pictures: Pictures;
  readonly groups: Groups;
  /** Every other part with marks that move at picture rate. */
  bars(): void;
  /** Every other part with figures, lamps or sounds. */
  values(view: View, measured: Measured, now: number): void;
  viewOf(frame: Frame): View;
}

export class DrawLoop {
  /** Number of pictures drawn. */
  drawn = 0;
  /** What the whole page shows of the run: pictures, lamps and figures. */
  shown: { readonly frame: Frame | null; readonly restarts: number } = { frame: null, restarts: 0 };
  /** What the figures are of. */
  private figures = this.shown;
  /** A frame has come since the last picture. */
  private fresh = false;
  /** The next picture waits for the frame that answers a stick. */
  private held = false;
  private valuesAt = 0;
  private readonly modes: ReadonlyMap<string, ModeInfo['kind']>;

  /** `barPace`: pictures for each movement of the bars. */
  constructor(
    welcome: Welcome,
    private readonly barPace: number,
    private readonly arrivals: Arrivals,
    private readonly latency: Latency,
    private readonly operator: Operator,
    private readonly parts: Drawn,
  ) {
    this.modes = new Map(welcome.modes.map(({ position, kind }) => [position, kind]));
  }

  /** A frame has come. */
  arrived(now: number): void {
    this.fresh = true;
    if (this.held) this.draw(now);
  }

  /** Draws what is due, once the pictures of the frame before are on the page. */
  draw(now: number): void {
    const [told, seen] = [this.arrivals.at('telemetry', now), this.arrivals.at('camera', now)];
    if (!told || !seen) return;
    const { pictures, groups } = this.parts;
    const view = this.parts.viewOf(told.frame);
    if (pictures.drawing) {
      // Figures, lamps and tones do not wait for a picture that takes long.
      if (now - this.valuesAt >= OVERDUE_MS) this.values(view, now);
      return;
    }
    this.held = this.latency.due(seen.frame.display.stick_seq, now);
    if (this.held) return;
    this.operator.sticks.driving = this.modes.get(told.frame.mode) === 'single';
    // Where bars wait for a picture, it is not one with MON 2 in it.
    const barsMove = (this.drawn + 1) % this.barPace === 0;
    this.fresh = false;
    // Pictures first: they read the page's layout, which the desk's bars invalidate.
    pictures.draw(seen.frame, seen.frame.work.clearance_level, () => this.pictured(seen));
    if (barsMove) groups.bars(view);
    this.parts.bars();
    if (barsMove && now - this.valuesAt >= VALUES_MS) this.values(view, now);
  }

  /** The pictures of a frame are on the page. */
  private pictured(seen: Seen): void {
    const now = performance.now();
    this.drawn += 1;
    this.shown = this.figures;
    this.latency.drawn(seen.frame.display.stick_seq, now);
    this.arrivals.show('camera', seen, now);
    if (this.fresh) this.draw(now);
  }

  private values(view: View, now: number): void {
    this.valuesAt = now;
    const { pictures, groups } = this.parts;
    const [told, seen] = [this.arrivals.at('telemetry', now), this.arrivals.at('camera', now)];
    if (told) this.arrivals.show('telemetry', told, now);
    pictures.setTime({ ...view, frame: seen?.frame ?? view.frame }, this.arrivals.age('camera', now));
    setClass(document.body, 'stale', isStale(this.arrivals.age('telemetry', now)));
    groups.values(view);
    const delays = this.arrivals.delays(this.latency.answer(now), now);
    this.parts.values(view, { picture: this.latency.percentile95(now), delays }, now);
    this.figures = { frame: view.frame, restarts: this.arrivals.restarts };
    if (!pictures.drawing) this.shown = this.figures;
  }
}

/** Decides when pictures, bars and numbers are drawn, and from which frame. Numbers change ten times a second. */

import type { Pictures } from '../cameras/pictures';
import type { Arrivals } from '../link/arrivals';
import type { Seen } from '../link/frames';
import type { Latency } from '../link/latency';
import type { Frame, ModeInfo, Welcome } from '../link/protocol';
import type { Groups } from '../panel/desk/desk';
import type { View } from '../panel/parts/part';
import type { Measured } from '../panel/rail/rail';
import type { Operator } from './operator';

/** Time between two updates of numbers and legends [ms]. */
const VALUES_MS = 100;
/** While a picture takes long to draw, the displayed numbers are updated at this interval [ms]. */
const OVERDUE_MS = 300;

/** The parts of the page that the loop draws. */
export interface Drawn {
  readonly pictures: Pictures;
  readonly groups: Groups;
  /** Draws the moving marks outside the pictures and the groups; called at each picture. */
  bars(): void;
  /** Updates the sounds, and the numbers and lamps outside the pictures and the groups. */
  values(view: View, measured: Measured, now: number): void;
  viewOf(frame: Frame): View;
}

export class DrawLoop {
  /** Number of pictures drawn. */
  drawn = 0;
  /** Last frame that pictures, lamps and read-outs have all displayed, and the count of restarts before this frame. */
  shown: { readonly frame: Frame | null; readonly restarts: number } = { frame: null, restarts: 0 };
  /** Last frame that lamps and read-outs have displayed, and the count of restarts before this frame. */
  private figures = this.shown;
  /** Whether a frame has arrived since the last picture. */
  private fresh = false;
  /** Whether the next picture waits for the frame that contains the newest stick motion. */
  private held = false;
  private valuesAt = 0;
  /** Number of times that the pictures were to be drawn. */
  private turns = 0;
  private readonly modes: ReadonlyMap<string, ModeInfo['kind']>;

  /** `barPace`: the bars move once in this number of pictures. */
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

  /** Called when a frame has arrived, at `now` [ms]. */
  arrived(now: number): void {
    this.fresh = true;
    if (this.held) this.draw(now);
  }

  /** Draws what is due. Until the previous pictures are on the page, updates only overdue numbers, lamps and tones. */
  draw(now: number): void {
    const { arrivals } = this;
    const [telemetry, seen, frames] = [arrivals.at('telemetry'), arrivals.at('camera'), arrivals.pictures];
    if (!telemetry || !seen || !frames) return;
    const { pictures, groups } = this.parts;
    const view = this.parts.viewOf(telemetry.frame);
    if (pictures.drawing) {
      // Numbers, lamps and tones do not wait longer than OVERDUE_MS for slow pictures.
      if (now - this.valuesAt >= OVERDUE_MS) this.values(view, telemetry, now);
      return;
    }
    const late = arrivals.late('camera');
    this.held = late === 0 && this.latency.due(seen.frame.display.stick_seq, now);
    if (this.held) return;
    this.operator.sticks.driving = this.modes.get(telemetry.frame.mode) === 'single';
    // The bars move even if no picture is drawn.
    this.turns += 1;
    const barsMove = this.turns % this.barPace === 0;
    this.fresh = false;
    // Pictures first: they read the page's layout, and moving the desk's bars forces the browser to compute it again.
    pictures.draw(frames, () => this.pictured(seen, late));
    if (barsMove) groups.bars(view);
    this.parts.bars();
    if (barsMove && now - this.valuesAt >= VALUES_MS) this.values(view, telemetry, now);
  }

  /** Called when the pictures of a frame are on the page: counts them and measures their latency without the link's. */
  private pictured(seen: Seen, late: number): void {
    const now = performance.now();
    this.drawn += 1;
    this.shown = this.figures;
    this.latency.drawn(seen.frame.display.stick_seq, now, late);
    this.arrivals.show('camera', seen, now);
    if (this.fresh) this.draw(now);
  }

  private values(view: View, telemetry: Seen, now: number): void {
    this.valuesAt = now;
    const { pictures, groups } = this.parts;
    pictures.setTime(view);
    groups.values(view);
    const delays = this.arrivals.delays(this.latency.answer(now), now);
    this.parts.values(view, { picture: this.latency.percentile95(now), delays }, now);
    this.arrivals.show('telemetry', telemetry, now);
    this.figures = telemetry;
    if (!pictures.drawing) this.shown = this.figures;
  }
}

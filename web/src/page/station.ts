/** The operator's station: applies the server's messages to the parts of the page, and draws these parts. */

import type { Sharpness } from '../cameras/fineness';
import type { Views } from '../cameras/pictures';
import type { PolygonPictures } from '../link/polygon-pictures';
import type {
  Completed,
  Frame,
  Event as LogEvent,
  Readiness,
  Role,
  Scenarios,
  Typed,
  Welcome,
} from '../link/protocol';
import type { Command, LinkState } from '../link/socket';
import { setClass } from '../panel/parts/dom';
import type { DrawnBody } from '../scene/bodies';
import { buildParts } from './build';
import { NO_CONNECTION } from './control';
import { DrawLoop } from './draw-loop';
import { keyRows } from './key-rows';
import { LOST_MS } from './operator';
import type { Parts } from './parts';
import { place } from './placement';
import type { Drawing } from './quality';
import { Readouts } from './readouts';

/** Number of pictures for each movement of the bars, by quality of the drawing. */
const BAR_PACE = { full: 1, low: 2 } as const;

export class Station {
  private readonly parts: Parts;
  private readonly loop: DrawLoop;
  private readonly ended = new AbortController();
  private request = 0;
  /** Number of restarts before the frame that the numbers show. */
  private restarts = 0;
  /** Whether the station knows that this page has drawn its first pictures. */
  private saidDrawn = false;

  constructor(
    root: HTMLElement,
    welcome: Welcome,
    drawing: Drawing,
    private readonly transmit: (command: Command) => number,
  ) {
    this.parts = buildParts(root, welcome, drawing, transmit);
    place(root, this.parts);
    this.parts.calm.gather(); // before the opening shot takes a monitor away
    this.parts.opening.begin(this.parts.calm.on);
    const { tones, windows, arrivals, latency, operator } = this.parts;
    const { signal } = this.ended;
    keyRows(root, signal);
    for (const used of ['keydown', 'pointerdown'] as const)
      document.addEventListener(used, () => tones.wake(), { signal });
    window.addEventListener('resize', () => this.parts.log.resized(), { signal });
    window.addEventListener('pagehide', () => windows.gone(), { signal });
    const pace = BAR_PACE[drawing.quality];
    this.loop = new DrawLoop(welcome, pace, arrivals, latency, operator, new Readouts(this.parts));
    this.request = requestAnimationFrame(() => this.tick());
  }

  /** Number of pictures drawn. */
  get drawn(): number {
    return this.loop.drawn;
  }

  get shown(): DrawLoop['shown'] {
    return this.loop.shown;
  }

  get bodies(): readonly DrawnBody[] {
    return this.parts.pictures.bodies;
  }

  get sharpness(): Sharpness | null {
    return this.parts.pictures.sharpness;
  }

  /** Survey of all cameras at the frame drawn last. */
  get views(): Views | null {
    return this.parts.pictures.views();
  }

  /** Time from a stick to its picture, 95th percentile of the last 10 s [ms]; null if no stick moved. */
  get latency95(): number | null {
    return this.parts.latency.percentile95(performance.now());
  }

  /** Stores a newer frame, which names the frames that numbers and pictures show. */
  setFrame(frame: Frame): void {
    const now = performance.now();
    const { arrivals, latency, operator, spine } = this.parts;
    // After a restart, no frame will use stick messages that were in the command delay.
    if (arrivals.put(frame, now)) latency.forget();
    const restarts = arrivals.at('telemetry')?.restarts ?? 0;
    if (restarts !== this.restarts) spine.forget();
    this.restarts = restarts;
    operator.sticks.kept = frame.rate_hold;
    latency.answered(frame.display.flown_seq, now);
    this.loop.arrived(now);
  }

  /** Pictures in the look of 1972, which the page asks for and receives. */
  get polygons(): PolygonPictures {
    return this.parts.polygons;
  }

  setRole(role: Role): void {
    this.parts.control.role = role;
    this.updateControl();
    this.parts.naming.set(role);
    setClass(document.body, 'watching', !role.flying);
    this.parts.windows.update();
  }

  setScenarios(list: Scenarios): void {
    this.parts.control.leaving = list.coming !== null;
    this.updateControl();
    this.parts.scenarios.set(list);
  }

  setTooNarrow(tooNarrow: boolean): void {
    this.parts.control.tooNarrow = tooNarrow;
    this.parts.operator.zero();
    this.updateControl();
  }

  setLink(link: LinkState): void {
    const { control, log } = this.parts;
    if (link.kind === 'lost' && control.link.kind !== 'lost') log.say(NO_CONNECTION);
    control.link = link;
    this.updateControl();
    if (link.kind !== 'open') this.parts.latency.forget();
  }

  /** Shows what is not ready. While the run stands still, the last frame is not old. */
  setReadiness(state: Readiness): void {
    const { readiness, arrivals } = this.parts;
    readiness.set(state);
    arrivals.stands = readiness.stands;
  }

  addEvents(events: readonly LogEvent[]): void {
    this.parts.log.add(events);
  }

  /** Shows what changes in flight have changed in the welcome. */
  changed(): void {
    this.parts.pictures.renew();
  }

  /** Shows an answer of the console. */
  answer(answer: Typed | Completed): void {
    if (answer.type === 'typed') this.parts.console.typed(answer);
    else this.parts.console.complete(answer);
  }

  forgetEvents(): void {
    this.parts.log.clear();
  }

  /** Shows why a command was rejected: below the name field if the command has set a name, otherwise in the log. */
  refuse(text: string, number: number): void {
    if (!this.parts.naming.refuse(number, text)) this.parts.log.refuse(text);
  }

  dispose(): void {
    cancelAnimationFrame(this.request);
    this.ended.abort();
    const { tones, operator, cameraHand, windows, task, pictures, freshness, opening } = this.parts;
    for (const part of [tones, operator, cameraHand, windows, task, pictures, freshness, opening])
      part.dispose();
  }

  /** Lets the sticks move the arm, or keeps them at zero, as `Control` decides. */
  private updateControl(): void {
    const { devices, operator, control, latency } = this.parts;
    devices.reportAgain();
    const { flying } = operator;
    operator.flying = control.flies;
    if (flying && !operator.flying) latency.forget(); // no frame will use the stick messages that have not arrived yet
  }

  private tick(): void {
    this.request = requestAnimationFrame(() => this.tick());
    const now = performance.now();
    const { arrivals, operator, swap, devices, control } = this.parts;
    if (1000 * arrivals.silence(now) > LOST_MS) operator.zero();
    operator.tick(now);
    swap.show();
    devices.watch(control.role.flying, operator.flying);
    this.loop.draw(now);
    if (!this.saidDrawn && this.loop.drawn > 0 && operator.flying) {
      this.saidDrawn = true;
      this.transmit({ type: 'drawn' });
    }
  }
}

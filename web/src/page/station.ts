/** The operator's station: monitors, spine and desk, drawn from the last frame alone. */

import { Pictures } from '../cameras/pictures';
import { CameraHand, together } from '../input/camera-hand';
import type { Action } from '../input/keymap';
import { keyOf } from '../input/layout';
import { reread } from '../input/store';
import { Arrivals } from '../link/delayed-messages';
import { Latency } from '../link/latency';
import type { Frame, Lamp, Event as LogEvent, Role, Scenarios, Welcome } from '../link/protocol';
import type { Command, LinkState } from '../link/socket';
import { clearanceCause } from '../panel/clearance/clearance';
import { ControllersSheet } from '../panel/controllers/controllers';
import { KeyMap } from '../panel/controllers/key-map';
import { swapQuestion } from '../panel/controllers/swap';
import { touchView } from '../panel/controllers/touch-sticks';
import { deskGroups, type Groups } from '../panel/desk/desk';
import { EventsGroup } from '../panel/desk/events';
import { el, setClass } from '../panel/parts/dom';
import type { Desk, View } from '../panel/parts/part';
import type { Delays } from '../panel/rail/delays';
import { handOver } from '../panel/rail/hand-over';
import { lightControl } from '../panel/rail/light';
import { naming } from '../panel/rail/naming';
import { calledFirst } from '../panel/rail/operator-name';
import { type Measured, rail } from '../panel/rail/rail';
import { type ScenarioChoice, scenarioChoice } from '../panel/rail/scenarios';
import { outline } from '../panel/spine/concerns';
import { lightSegments } from '../panel/spine/lamp-test';
import { LAMPS, type LampName, type SpineLamp } from '../panel/spine/lamps';
import { ownLamps } from '../panel/spine/own-lamps';
import { Spine } from '../panel/spine/spine';
import { ControlPage } from '../panel/target/control-page';
import type { DrawnBody } from '../scene/bodies';
import { Tutorial } from '../tutorial';
import { BLOCKED, type Torn, tearOff } from '../windows/opened';
import { type UnitName, unitsOf } from '../words/units';
import { act } from './commands';
import { Control } from './control';
import { DeviceWatch } from './device-watch';
import { DrawLoop } from './draw-loop';
import { keeper } from './local-storage';
import { Log } from './log';
import { LOST_MS, Operator } from './operator';
import type { Drawing } from './quality';
import { Report } from './report';
import { TOO_NARROW_WORDS } from './room';
import { Sounds } from './sounds';
import { Tones } from './tones';
import { WindowLink } from './window-link';

const [MOVE, TURN] = ['+X -X -Y +Y -Z +Z', '+pitch -pitch -yaw +yaw -roll +roll'];
/** Number of pictures for each movement of the bars. */
const BAR_PACE = { full: 1, low: 2 } as const;
const OBSERVING = 'Observing: only the operator can do that.';

export class Station {
  readonly latency: Latency;
  private readonly tones = new Tones(keeper, () => new AudioContext());
  private readonly arrivals: Arrivals;
  private readonly control = new Control();
  private readonly log: Log;
  private readonly loop: DrawLoop;
  private readonly sounds: Sounds;
  private readonly report: Report;
  private units: UnitName;
  private request = 0;
  private readonly ended = new AbortController();
  private readonly pictures: Pictures;
  private readonly operator: Operator;
  private readonly cameraHand: CameraHand;
  private readonly windows: WindowLink;
  private readonly spine = new Spine({
    acknowledged: () => this.acknowledge(),
    pressed: (lamp) => this.explain(lamp),
  });
  private readonly keys: KeyMap;
  private readonly sheet: ControllersSheet;
  private readonly controlPage: ControlPage;
  private readonly touch;
  private readonly swap;
  private readonly handOver = handOver((command) => this.transmit(command));
  private readonly naming = naming(keeper, (command) => this.transmit(command));
  private readonly devices: DeviceWatch;
  /** There is something that the orbiter can move against. */
  private readonly movable: boolean;
  private readonly groups: Groups;
  private readonly light;
  private readonly rail;
  private readonly tutorial: Tutorial;
  private readonly scenarios: ScenarioChoice;

  constructor(
    root: HTMLElement,
    welcome: Welcome,
    drawing: Drawing,
    private readonly transmit: (command: Command) => number,
  ) {
    this.latency = new Latency(welcome.camera_delay_s);
    this.arrivals = new Arrivals(welcome);
    this.keys = new KeyMap(welcome, () => this.changeControllers());
    this.units = welcome.units;
    const events = new EventsGroup([welcome.text, ...reread(), keysHint()]);
    this.log = new Log(events, this.arrivals);
    this.sounds = new Sounds(this.tones, this.spine);
    this.report = new Report(transmit);
    this.movable = welcome.work.cargo.length > 0;
    this.pictures = new Pictures(welcome, drawing, {
      tearOff: (what) => this.tearOff(what),
      turns: true,
      opened: (matrix) => this.showMatrix(root, matrix),
      changed: () => this.windows?.update(),
    });
    this.operator = new Operator(this.latency, {
      acted: (action) => this.act(action),
      send: transmit,
      taken: (event) => this.sheet.taken(event),
    });
    this.windows = new WindowLink(
      welcome,
      this.pictures,
      this.control,
      () => this.units,
      () => this.operator.zero(),
    );
    this.devices = new DeviceWatch(this.operator.controllers, {
      send: transmit,
      say: (text, level) => this.log.say(text, 'controller', level),
    });
    this.sheet = new ControllersSheet(this.operator.controllers);
    this.touch = touchView(this.operator.controllers.touch);
    this.swap = swapQuestion(this.operator.controllers.pads);
    this.cameraHand = new CameraHand(() => together(this.operator.turning, this.pictures.monitors.turning), {
      hand: () => this.pictures.monitors,
      barred: () => {
        if (!this.operator.flying) return 'Observing: only the operator can move cameras.';
        return this.arrivals.telemetry?.by === 'script'
          ? 'The script flies: take control to turn cameras.'
          : '';
      },
      say: (text) => this.log.say(text),
      send: transmit,
      orbit: (camera, ...by) => this.pictures.orbit(camera, ...by),
    });
    const desk: Desk = {
      welcome,
      send: (command) => this.send(command),
      say: (text) => this.log.say(text),
    };
    this.controlPage = new ControlPage(desk);
    this.groups = deskGroups(desk, events, {
      plane: () => this.showPlane(),
      controlPage: () => this.controlPage.toggle(),
      flyOrbiter: (on) => this.flyOrbiter(on),
      strips: () => this.tearOff('strips'),
    });
    this.scenarios = scenarioChoice(desk, (name) => this.tutorial.chosen(name));
    this.tutorial = new Tutorial(desk, this.operator.controllers.inHand, (name) =>
      this.scenarios.choose(name),
    );
    this.light = lightControl(desk, this.pictures);
    const { tones, light, scenarios, handOver, naming } = this;
    const parts = {
      tones,
      light,
      scenarios,
      naming,
      ask: handOver.ask,
      tutorial: this.tutorial.key,
      appearance: this.pictures.appearance,
    };
    this.rail = rail(desk, drawing.software && drawing.quality === 'low', parts, {
      units: () => {
        this.units = this.units === 'SI' ? 'ft-in' : 'SI';
        this.windows.update();
      },
      restart: () => this.send({ type: 'restart' }),
      keys: () => this.keys.toggle(),
      controllers: () => this.changeControllers(),
    });
    const [first, second] = this.pictures.monitors.both;
    setClass(root, 'all-cameras', false); // another station may have left it so
    // The order of the document is that of the focus: monitors, spine, desk, rail.
    root.replaceChildren(
      this.pictures.canvas,
      el('main', { class: 'monitors' }, first.element, second.element, this.spine.element),
      this.pictures.matrix.element,
      el('section', { class: 'desk', 'aria-label': 'Desk' }, ...this.groups.elements, this.tutorial.element),
      this.pictures.matrix.strip,
      this.rail.element,
      el('p', { class: 'too-narrow', role: 'status' }, TOO_NARROW_WORDS),
      this.touch.element,
      this.swap.element,
      this.handOver.question,
      this.scenarios.question,
      this.keys.element,
      this.controlPage.element,
      this.sheet.element,
    );
    for (const used of ['keydown', 'pointerdown'] as const)
      document.addEventListener(used, () => this.tones.wake(), { signal: this.ended.signal });
    window.addEventListener('blur', () => this.pictures.monitors.release(), { signal: this.ended.signal });
    window.addEventListener('pagehide', () => this.windows.gone(), {
      signal: this.ended.signal,
    });
    this.loop = new DrawLoop(welcome, BAR_PACE[drawing.quality], this.arrivals, this.latency, this.operator, {
      ...{ pictures: this.pictures, groups: this.groups },
      bars: () => this.bars(),
      values: (view, measured, now) => this.values(view, measured, now),
      viewOf: (frame) => this.viewOf(frame),
    });
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
    return this.pictures.bodies;
  }

  /** A newer frame; figures and pictures show it when they are due. */
  setFrame(frame: Frame): void {
    const now = performance.now();
    if (this.arrivals.put(frame, now)) {
      this.latency.forget(); // no frame will answer the sticks in the command delay
      this.log.add(this.arrivals.takeEvents());
    }
    this.operator.sticks.kept = frame.rate_hold;
    this.latency.answered(frame.display.flown_seq, now);
    this.loop.arrived(now);
  }

  setRole(role: Role): void {
    this.control.role = role;
    this.takeControl();
    this.naming.set(role);
    setClass(document.body, 'watching', !role.flying);
    this.windows.update();
  }

  setScenarios(told: Scenarios): void {
    this.control.leaving = told.coming !== null;
    this.takeControl();
    this.scenarios.set(told);
  }

  setTooNarrow(tooNarrow: boolean): void {
    this.control.tooNarrow = tooNarrow;
    this.operator.zero();
    this.takeControl();
  }

  setLink(link: LinkState): void {
    this.control.link = link;
    this.takeControl();
    if (link.kind !== 'open') this.latency.forget();
  }

  /** Lines of the log appear with the figures of their time. */
  addEvents(events: readonly LogEvent[]): void {
    this.arrivals.addEvents(events);
    this.log.addDue(performance.now());
  }

  forgetEvents(): void {
    this.log.clear();
  }

  /** Logs why a command was rejected, or shows it where a name was entered. */
  refuse(text: string, number: number): void {
    if (!this.naming.refuse(number, text)) this.log.refuse(text);
  }

  dispose(): void {
    cancelAnimationFrame(this.request);
    this.tones.dispose();
    this.ended.abort();
    this.operator.dispose();
    this.cameraHand.dispose();
    this.windows.dispose();
    this.tutorial.dispose();
    this.pictures.dispose();
  }

  /** The sticks move the arm, or rest, as `Control` says. */
  private takeControl(): void {
    this.devices.tellAgain();
    const { flying } = this.operator;
    this.operator.flying = this.control.flies;
    if (flying && !this.operator.flying) this.latency.forget(); // no frame will answer the sticks under way
  }

  private tick(): void {
    this.request = requestAnimationFrame(() => this.tick());
    const now = performance.now();
    if (1000 * this.arrivals.silence(now) > LOST_MS) this.operator.zero();
    this.operator.tick(now);
    this.swap.show();
    this.devices.watch(this.control.role.flying, this.operator.flying);
    this.log.addDue(now);
    this.loop.draw(now);
  }

  private viewOf(frame: Frame): View {
    return {
      frame,
      units: unitsOf(this.units),
      hand: this.operator.sticks.value,
      controllers: this.operator.controllers.shown,
      flier: calledFirst(this.control.role, this.control.role.flier),
      flying: this.control.role.flying,
      orbiting: this.operator.sticks.flyingOrbiter && this.control.role.flying,
    };
  }

  private bars(): void {
    this.keys.light(this.operator.controllers.keyboard.held);
    this.sheet.tick();
    this.touch.draw();
    this.tutorial.light();
  }

  private values(view: View, measured: Measured, now: number): void {
    const { role, link } = this.control;
    const test = view.frame.mode === 'TEST';
    this.controlPage.values(view);
    this.spine.show([...inUnits(view), ...this.ownLamps(measured.delays, now)], test);
    this.tutorial.values(view);
    this.rail.values(view, measured, this.handOver.words(role, now), link);
    this.sounds.update(view.frame);
    if (role.flying) this.report.update(measured.picture, this.pictures.monitors.shown, now);
    if (test) lightSegments();
  }

  private changeControllers(): void {
    this.keys.close();
    this.sheet.open();
  }

  private ownLamps(delays: Delays, now: number): readonly SpineLamp[] {
    const controllers = this.control.tooNarrow ? null : this.operator.controllers;
    const [silence, pictures] = [this.arrivals.silence(now), this.arrivals.age('camera', now)];
    return ownLamps({ refusedAt: this.log.refusedAt, silence, delays, pictures, controllers }, now);
  }

  private send(command: Command): void {
    if (this.control.role.flying) this.transmit(command);
    else this.log.say(OBSERVING);
  }

  private acknowledge(): void {
    this.operator.controllers.acknowledge();
    this.spine.acknowledge();
  }

  /** A lamp was pressed: the log keeps to its cause, and what it speaks of is outlined. */
  private explain(lamp: LampName): void {
    const concern = LAMPS[lamp];
    this.log.keepTo(lamp, concern.kinds);
    outline(concern);
  }

  /** Everything that this page moves comes to rest; the master arm is left where the arm is. */
  private stop(): void {
    if (!this.control.role.flying) return;
    this.transmit({ type: 'stop' });
    if (this.loop.kindOf(this.arrivals.telemetry?.mode ?? '') === 'master') this.groups.meetMaster();
  }

  private showPlane(): void {
    this.groups.setPlane(this.pictures.togglePlane());
    this.windows.update();
  }

  /** All cameras in place of monitors and desk, whose clearance and lamps stay in sight. */
  private showMatrix(root: HTMLElement, on: boolean): void {
    setClass(root, 'all-cameras', on);
    const { matrix } = this.pictures;
    if (on) matrix.open(root.querySelector('.desk > .clearance'), this.spine.element);
    else matrix.close();
  }

  private tearOff(what: Torn): void {
    if (!tearOff(what)) this.log.say(BLOCKED);
  }

  private flyOrbiter(on: boolean): void {
    if (!this.control.role.flying) this.log.say(OBSERVING);
    else this.operator.sticks.flyOrbiter(on && this.movable);
  }

  private act(action: Action): void {
    this.tutorial.acted(action);
    const { groups, pictures, light, controlPage, keys, sheet, rail } = this;
    act(action, {
      ...{ groups, pictures, light, controlPage, keys },
      sheets: [sheet, rail],
      stop: () => this.stop(),
      changeRate: () =>
        this.send({
          type: 'select_rate',
          rate: this.arrivals.telemetry?.rate === 'coarse' ? 'vernier' : 'coarse',
        }),
      holdRate: () => this.send({ type: 'rate_hold' }),
      acknowledge: () => this.acknowledge(),
      showPlane: () => this.showPlane(),
      flyOrbiter: () => this.flyOrbiter(!this.operator.sticks.flyingOrbiter),
    });
  }
}

/** The keys that fly, as they are mapped when the page opens. */
function keysHint(): string {
  const keys = (uses: string) => uses.split(' ').map(keyOf).join(' ');
  return `${keys(MOVE)} move the point, ${keys(TURN)} turn it. ${keyOf('stop')} stops. ? shows all keys.`;
}

/** The frame's lamps, CLEARANCE with how much there is of it in the operator's units. */
function inUnits({ frame, units }: View): readonly Lamp[] {
  const { nearest } = frame.work;
  return frame.display.lamps.map((lamp) =>
    lamp.name === 'CLEARANCE' && nearest ? { ...lamp, text: clearanceCause(nearest, units) } : lamp,
  );
}

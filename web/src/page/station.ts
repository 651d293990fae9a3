/** The operator's station: monitors, spine and desk, drawn from the last frame alone. */

import { Pictures } from '../cameras/pictures';
import { CameraHand, together } from '../input/camera-hand';
import { RelayedKeys } from '../input/key-relay';
import type { Action } from '../input/keymap';
import { keyOf } from '../input/layout';
import { reread } from '../input/store';
import { isStale, type Seen } from '../link/delay-line';
import { Arrivals } from '../link/delayed-messages';
import { pageName } from '../link/identity';
import { Latency } from '../link/latency';
import type {
  Frame,
  Lamp,
  Level,
  Event as LogEvent,
  ModeInfo,
  Role,
  Scenarios,
  Welcome,
} from '../link/protocol';
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
import { rail } from '../panel/rail/rail';
import { type ScenarioChoice, scenarioChoice } from '../panel/rail/scenarios';
import { outline } from '../panel/spine/concerns';
import { lightSegments } from '../panel/spine/lamp-test';
import { LAMPS, type LampName, type SpineLamp } from '../panel/spine/lamps';
import { ownLamps } from '../panel/spine/own-lamps';
import { Spine } from '../panel/spine/spine';
import { ControlPage } from '../panel/target/control-page';
import type { DrawnBody } from '../scene/bodies';
import { Tutorial } from '../tutorial';
import { BLOCKED, type Torn, tearOff, Windows } from '../windows/opened';
import { type UnitName, unitsOf } from '../words/units';
import { act } from './commands';
import { DeviceWatch } from './device-watch';
import { keeper } from './local-storage';
import { LOST_MS, Operator } from './operator';
import type { Drawing } from './quality';
import { Tones } from './tones';
import { TOO_NARROW_WORDS } from './width';

/** Figures and legends change this often [ms]. */
const VALUES_MS = 100;
/** So long may they wait for a picture [ms]. */
const OVERDUE_MS = 300;
const [MOVE, TURN] = ['+X -X -Y +Y -Z +Z', '+pitch -pitch -yaw +yaw -roll +roll'];
/** The station is told this often what the page measures [ms]. */
const TOLD_MS = 1000;
/** Bars move each so many times that the pictures do. */
const BAR_PACE = { full: 1, low: 2 } as const;
/** The log told anew holds older refusals, which light nothing [s]. */
const RECENT_S = 2;

export class Station {
  /** Pictures drawn so far, what the whole page shows of the flight, and the latencies measured. */
  drawn = 0;
  shown: { readonly frame: Frame | null; readonly restarts: number } = { frame: null, restarts: 0 };
  readonly latency: Latency;
  private readonly tones = new Tones(keeper, () => new AudioContext());
  /** What the last frame showed, for the clicks. */
  private heard = { mode: '', held: 0 };
  /** What the figures are of. */
  private figures = this.shown;
  private readonly arrivals: Arrivals;
  private fresh = false;
  /** The next picture waits for the frame that answers a stick. */
  private held = false;
  private valuesAt = 0;
  private toldAt = 0;
  private toldOf = '';
  private role: Role = {
    type: 'role',
    flying: false,
    watchers: 0,
    number: 0,
    flier: 0,
    asking: 0,
    name: '',
    names: [],
  };
  private link: LinkState = { kind: 'open' };
  private tooNarrow = false;
  private units: UnitName;
  /** When something was refused last [ms]. */
  private refusedAt = -Infinity;
  private request = 0;
  private readonly barPace: number;
  private readonly ended = new AbortController();
  private readonly pictures: Pictures;
  private readonly operator: Operator;
  private readonly cameraHand: CameraHand;
  private readonly windows: Windows;
  private readonly relayed = new RelayedKeys(() => this.operator.zero());
  private readonly spine = new Spine({
    acknowledged: () => this.acknowledge(),
    pressed: (lamp) => this.explain(lamp),
  });
  private readonly events: EventsGroup;
  private readonly keys: KeyMap;
  private readonly sheet: ControllersSheet;
  private readonly controlPage: ControlPage;
  private readonly touch;
  private readonly swap;
  private readonly handOver = handOver((command) => this.transmit(command));
  private readonly naming = naming(keeper, (command) => this.transmit(command));
  private readonly devices: DeviceWatch;
  private readonly modes: ReadonlyMap<string, ModeInfo['kind']>;
  /** There is something that the orbiter can move against. */
  private readonly movable: boolean;
  private readonly groups: Groups;
  private readonly light;
  private readonly rail;
  private readonly tutorial: Tutorial;
  private readonly scenarios: ScenarioChoice;
  /** Another scenario is made ready: the sticks rest. */
  private leaving = false;

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
    this.barPace = BAR_PACE[drawing.quality];
    this.events = new EventsGroup([welcome.text, ...reread(), keysHint()]);
    this.modes = new Map(welcome.modes.map(({ position, kind }) => [position, kind]));
    this.movable = welcome.work.cargo.length > 0;
    this.pictures = new Pictures(welcome, drawing, {
      tearOff: (what) => this.tearOff(what),
      turns: true,
      opened: (matrix) => this.showMatrix(root, matrix),
      changed: () => this.tellWindows(),
    });
    this.windows = new Windows(pageName(), (said) => {
      if (said.kind === 'ask') this.tellWindows();
      else if (said.kind === 'show') this.pictures.show(said.monitor, said.names);
      else if (said.kind === 'put') {
        const camera = welcome.cameras.find(({ name }) => name === said.name);
        if (camera) this.pictures.choose(camera);
      } else if (said.kind === 'take') {
        const { hand, monitors } = this.pictures;
        if (this.role.flying && hand !== monitors[said.monitor]) this.pictures.takeMonitor(said.monitor);
      } else if (said.kind === 'key' || said.kind === 'holding' || said.kind === 'released') {
        if (this.role.flying) this.relayed.take(said);
      }
    });
    this.operator = new Operator(this.latency, {
      acted: (action) => this.act(action),
      send: transmit,
      taken: (event) => this.sheet.taken(event),
    });
    this.devices = new DeviceWatch(this.operator.controllers, {
      send: transmit,
      say: (text, level) => this.say(text, 'controller', level),
    });
    this.sheet = new ControllersSheet(this.operator.controllers);
    this.touch = touchView(this.operator.controllers.touch);
    this.swap = swapQuestion(this.operator.controllers.pads);
    this.cameraHand = new CameraHand(() => together(this.operator.turning, this.pictures.turning), {
      hand: () => this.pictures,
      barred: () => {
        if (!this.operator.flying) return 'You watch; only the one who flies turns cameras.';
        return this.frame?.by === 'script'
          ? 'The script flies: take the sticks, then the cameras turn, too.'
          : '';
      },
      say: (text) => this.say(text),
      send: transmit,
      orbit: (camera, ...by) => this.pictures.orbit(camera, ...by),
    });
    const desk: Desk = {
      welcome,
      send: (command) => this.send(command),
      say: (text) => this.say(text),
    };
    this.controlPage = new ControlPage(desk);
    this.groups = deskGroups(desk, this.events, {
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
        this.tellWindows();
      },
      restart: () => this.send({ type: 'restart' }),
      keys: () => this.keys.toggle(),
      controllers: () => this.changeControllers(),
    });
    const [first, second] = this.pictures.monitors;
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
    window.addEventListener('blur', () => this.pictures.release(), { signal: this.ended.signal });
    window.addEventListener('pagehide', () => this.windows.say({ kind: 'gone' }), {
      signal: this.ended.signal,
    });
    this.request = requestAnimationFrame(() => this.tick());
  }

  get bodies(): readonly DrawnBody[] {
    return this.pictures.bodies;
  }

  /** A newer frame; figures and pictures show it when they are due. */
  setFrame(frame: Frame): void {
    const now = performance.now();
    if (this.arrivals.put(frame, now)) {
      this.latency.forget(); // what was under way is flown by nobody
      this.log(this.arrivals.takeEvents());
    }
    this.operator.sticks.kept = frame.rate_hold;
    this.latency.answered(frame.display.flown_seq, now);
    this.fresh = true;
    if (this.held) this.draw(now);
  }

  setRole(role: Role): void {
    this.role = role;
    this.devices.tellAgain();
    this.takeRole();
    this.naming.set(role);
    setClass(document.body, 'watching', !role.flying);
    this.tellWindows();
  }

  setScenarios(told: Scenarios): void {
    this.leaving = told.coming !== null;
    this.devices.tellAgain();
    this.takeRole();
    this.scenarios.set(told);
  }

  /** Where the window is too narrow, the page watches only. */
  setTooNarrow(tooNarrow: boolean): void {
    this.tooNarrow = tooNarrow;
    this.devices.tellAgain();
    this.operator.zero();
    this.takeRole();
  }

  setLink(link: LinkState): void {
    this.link = link;
    this.devices.tellAgain();
    this.takeRole();
    if (link.kind !== 'open') this.latency.forget();
  }

  /** Lines of the log come with the figures of their time. */
  addEvents(events: readonly LogEvent[]): void {
    this.arrivals.addEvents(events);
    this.log(this.arrivals.dueEvents(performance.now()));
  }

  private log(events: readonly LogEvent[]): void {
    if (events.length === 0) return;
    const recent = (this.frame?.time_s ?? 0) - RECENT_S;
    const refused = events.some(({ kind, time_s }) => kind === 'refused' && time_s >= recent);
    if (refused && this.frame) this.refusedAt = performance.now();
    this.events.add(events);
  }

  forgetEvents(): void {
    this.arrivals.takeEvents();
    this.events.clear();
  }

  /** A command was not taken: the log says why, and CHECK CRT sends the eye there. */
  refuse(text: string, number: number): void {
    if (this.naming.refuse(number, text)) return;
    this.refusedAt = performance.now();
    this.say(text);
  }

  dispose(): void {
    cancelAnimationFrame(this.request);
    this.tones.dispose();
    this.ended.abort();
    this.operator.dispose();
    this.cameraHand.dispose();
    this.relayed.dispose();
    this.windows.dispose();
    this.tutorial.dispose();
    this.pictures.dispose();
  }

  /** The sticks are this page's only while it flies what is flown. */
  private takeRole(): void {
    const { flying } = this.operator;
    this.operator.flying = this.role.flying && this.link.kind === 'open' && !this.leaving && !this.tooNarrow;
    if (flying && !this.operator.flying) this.latency.forget(); // what was under way is flown by nobody
  }

  private tick(): void {
    this.request = requestAnimationFrame(() => this.tick());
    const now = performance.now();
    if (1000 * this.arrivals.silence(now) > LOST_MS) this.operator.zero();
    this.operator.tick(now);
    this.swap.show();
    this.devices.watch(this.role.flying, this.operator.flying);
    this.log(this.arrivals.dueEvents(now));
    this.draw(now);
  }

  /** What figures, lamps and log are of. */
  private get frame(): Frame | null {
    return this.arrivals.at('telemetry', performance.now())?.frame ?? null;
  }

  /** Draws what is due, once the pictures of the frame before are on the page. */
  private draw(now: number): void {
    const [told, seen] = [this.arrivals.at('telemetry', now), this.arrivals.at('camera', now)];
    if (!told || !seen) return;
    const view = this.viewOf(told.frame);
    if (this.pictures.drawing) {
      // Figures, lamps and tones do not wait for a picture that is long under way.
      if (now - this.valuesAt >= OVERDUE_MS) this.values(view, now);
      return;
    }
    this.held = this.latency.due(seen.frame.display.stick_seq, now);
    if (this.held) return;
    this.operator.sticks.driving = this.modes.get(told.frame.mode) === 'single';
    // Where bars wait for a picture, it is not one with MON 2 in it.
    const barsMove = (this.drawn + 1) % this.barPace === 0;
    this.fresh = false;
    // The pictures first: they read the page's places, which the desk's bars unsettle.
    this.pictures.draw(seen.frame, seen.frame.work.clearance_level, () => this.pictured(seen));
    if (barsMove) this.groups.bars(view);
    this.keys.light(this.operator.controllers.keyboard.held);
    this.sheet.tick();
    this.touch.draw();
    this.tutorial.light();
    if (barsMove && now - this.valuesAt >= VALUES_MS) this.values(view, now);
  }

  private viewOf(frame: Frame): View {
    return {
      frame,
      units: unitsOf(this.units),
      hand: this.operator.sticks.value,
      controllers: this.operator.controllers.shown,
      flier: calledFirst(this.role, this.role.flier),
      flying: this.role.flying,
      orbiting: this.operator.sticks.flyingOrbiter && this.role.flying,
    };
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
    const [told, seen] = [this.arrivals.at('telemetry', now), this.arrivals.at('camera', now)];
    if (told) this.arrivals.show('telemetry', told, now);
    this.pictures.setTime({ ...view, frame: seen?.frame ?? view.frame }, this.arrivals.age('camera', now));
    setClass(document.body, 'stale', isStale(this.arrivals.age('telemetry', now)));
    this.groups.values(view);
    this.controlPage.values(view);
    const test = view.frame.mode === 'TEST';
    const delays = this.arrivals.delays(this.latency.answer(now), now);
    this.spine.show([...inUnits(view), ...this.ownLamps(delays, now)], test);
    const latency95 = this.latency.percentile95(now);
    this.tutorial.values(view);
    const measured = { picture: latency95, delays };
    this.rail.values(view, measured, this.handOver.words(this.role, now), this.link);
    this.sound(view.frame);
    const monitors = this.pictures.shown;
    const due = now - this.toldAt >= TOLD_MS || monitors.join('/') !== this.toldOf;
    if (this.role.flying && due) {
      [this.toldAt, this.toldOf] = [now, monitors.join('/')];
      this.transmit({ type: 'shown', latency_ms: latency95, monitors });
    }
    if (test) lightSegments();
    this.figures = { frame: view.frame, restarts: this.arrivals.restarts };
    if (!this.pictures.drawing) this.shown = this.figures;
  }

  /** Alarms until they are acknowledged, and clicks for a mode entered and a payload captured. */
  private sound(frame: Frame): void {
    const { alarm, more } = this.spine.takeAlarm();
    this.tones.sound(alarm, more);
    this.spine.setMuted(this.tones.muted);
    const now = { mode: frame.mode, held: frame.work.cargo.filter(({ held }) => held).length };
    if (this.heard.mode !== '' && now.mode !== this.heard.mode) this.tones.entered();
    if (this.heard.mode !== '' && now.held > this.heard.held) this.tones.captured();
    this.heard = now;
  }

  private changeControllers(): void {
    this.keys.close();
    this.sheet.open();
  }

  private ownLamps(delays: Delays, now: number): readonly SpineLamp[] {
    const controllers = this.tooNarrow ? null : this.operator.controllers;
    const [silence, pictures] = [this.arrivals.silence(now), this.arrivals.age('camera', now)];
    return ownLamps({ refusedAt: this.refusedAt, silence, delays, pictures, controllers }, now);
  }

  private send(command: Command): void {
    if (this.role.flying) this.transmit(command);
    else this.say('You watch; only the one who flies can do that.');
  }

  private say(text: string, kind = 'page', level: Level = 'caution'): void {
    this.events.add([{ time_s: this.frame?.time_s ?? 0, kind, level, text }]);
  }

  private acknowledge(): void {
    this.operator.controllers.acknowledge();
    this.spine.acknowledge();
  }

  /** A lamp was pressed: the log keeps to its cause, and what it speaks of is outlined. */
  private explain(lamp: LampName): void {
    const concern = LAMPS[lamp];
    this.events.keepTo(lamp, concern.kinds);
    outline(concern);
  }

  /** Everything that this page moves comes to rest; the master arm is left where the arm is. */
  private stop(): void {
    if (!this.role.flying) return;
    this.transmit({ type: 'stop' });
    if (this.modes.get(this.frame?.mode ?? '') === 'master') this.groups.meetMaster();
  }

  private showPlane(): void {
    this.groups.setPlane(this.pictures.togglePlane());
    this.tellWindows();
  }

  /** All cameras in place of monitors and desk, whose clearance and lamps stay in sight. */
  private showMatrix(root: HTMLElement, on: boolean): void {
    setClass(root, 'all-cameras', on);
    const { matrix } = this.pictures;
    if (on) matrix.open(root.querySelector('.desk > .clearance'), this.spine.element);
    else matrix.close();
  }

  private tellWindows(): void {
    const { shown: monitors, showsPlane: plane } = this.pictures;
    const { units, role } = this;
    this.windows?.say({ kind: 'page', monitors, plane, units, takesKeys: role.flying });
  }

  private tearOff(what: Torn): void {
    if (!tearOff(what)) this.say(BLOCKED);
  }

  private flyOrbiter(on: boolean): void {
    if (!this.role.flying) this.say('You watch; only the one who flies can do that.');
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
        this.send({ type: 'select_rate', rate: this.frame?.rate === 'coarse' ? 'vernier' : 'coarse' }),
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

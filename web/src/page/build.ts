/** Makes the parts of the operator's page and connects them. */

import type { PairOffer } from '../cameras/pair-offer';
import { Pictures } from '../cameras/pictures';
import { CameraHand, together } from '../input/camera-hand';
import { keyOf } from '../input/layout';
import { reread } from '../input/store';
import { Arrivals } from '../link/arrivals';
import { Latency } from '../link/latency';
import { PolygonPictures } from '../link/polygon-pictures';
import type { Welcome } from '../link/protocol';
import type { Command } from '../link/socket';
import { Calm } from '../panel/calm/calm';
import { Console } from '../panel/console/console';
import { ControllersSheet } from '../panel/controllers/controllers';
import { KeyMap } from '../panel/controllers/key-map';
import { swapQuestion } from '../panel/controllers/swap';
import { touchView } from '../panel/controllers/touch-sticks';
import { deskGroups } from '../panel/desk/desk';
import { EventsGroup } from '../panel/desk/events';
import { pairNotice } from '../panel/monitors/pair-notice';
import type { Desk } from '../panel/parts/part';
import { handOver } from '../panel/rail/hand-over';
import { lightControl } from '../panel/rail/light';
import { naming } from '../panel/rail/naming';
import { type Rail, rail } from '../panel/rail/rail';
import { type ScenarioChoice, scenarioChoice } from '../panel/rail/scenarios';
import { Spine } from '../panel/spine/spine';
import { ControlPage } from '../panel/target/control-page';
import { Task } from '../task';
import { ShownUnits } from '../words/units';
import { Control } from './control';
import { DeviceWatch } from './device-watch';
import { Freshness } from './freshness';
import { keeper } from './local-storage';
import { Log } from './log';
import { Opening } from './opening';
import { Operations } from './operations';
import { Operator } from './operator';
import type { Parts } from './parts';
import type { Drawing } from './quality';
import { ReadinessNotice } from './readiness';
import { Report } from './report';
import { Sounds } from './sounds';
import { Tones } from './tones';
import { WindowLink } from './window-link';

const [MOVE, TURN] = ['+X -X -Y +Y -Z +Z', '+pitch -pitch -yaw +yaw -roll +roll'];

/** `transmit` sends a command to the station and returns the command's number. */
export function buildParts(
  root: HTMLElement,
  welcome: Welcome,
  drawing: Drawing,
  transmit: (command: Command) => number,
): Parts {
  // `operations` is made last. The other parts use it only in callbacks, and no constructor calls a callback.
  const tones = new Tones(keeper, () => new AudioContext());
  const control = new Control();
  const spine = new Spine({
    acknowledged: () => operations.acknowledge(),
    pressed: (lamp) => operations.explain(lamp),
  });
  const units = new ShownUnits(welcome.units);
  const latency = new Latency();
  const arrivals = new Arrivals(welcome);
  const keys = new KeyMap(welcome, () => operations.openControllers());
  const events = new EventsGroup([welcome.text, ...reread(), keysHint()]);
  const log = new Log(events, arrivals);
  const polygons = new PolygonPictures(transmit);
  const pictures = new Pictures(welcome, drawing, {
    polygons,
    tearOff: (what) => operations.tearOff(what),
    turns: true,
    opened: (matrix) => operations.showMatrix(matrix),
    changed: () => windows.update(),
    offered: (offer) => notice.show(offer),
    simplified: (why) => {
      topRail.simplified(why);
      log.say(why, 'camera', 'caution');
    },
  });
  const notice = pairNotice(
    () => pictures.offers.take(),
    () => pictures.offers.offer(null),
    () => operator.controllers.inHand,
  );
  const operator = new Operator(latency, {
    acted: (action) => operations.act(action),
    send: transmit,
    taken: (event) => sheet.taken(event),
    pressedInVain: () => log.sayOnce(control.bar),
  });
  const { controllers } = operator;
  const windows: WindowLink = new WindowLink(
    welcome,
    pictures,
    control,
    () => units.name,
    () => operator.zero(),
  );
  const devices = new DeviceWatch(controllers, {
    send: transmit,
    say: (text, level) => log.say(text, 'controller', level),
  });
  const sheet: ControllersSheet = new ControllersSheet(controllers);
  const cameraHand = new CameraHand(() => together(operator.turning, pictures.monitors.turning), {
    hand: () => pictures.monitors,
    barred: () => operations.cameraBar(),
    say: (text) => log.say(text),
    send: transmit,
    orbit: (camera, ...by) => pictures.orbit(camera, ...by),
  });
  const desk: Desk = {
    welcome,
    send: (command) => operations.send(command),
    act: (name) => operations.act({ name }),
    say: (text) => log.say(text),
  };
  const controlPage = new ControlPage(desk);
  const typewriter = new Console(transmit);
  const groups = deskGroups(desk, events, {
    flyOrbiter: (on) => operations.flyOrbiter(on),
    pulse: () => operations.togglePulse(),
    strips: () => operations.tearOff('strips'),
  });
  const scenarios: ScenarioChoice = scenarioChoice(desk, (name) => task.chosen(name));
  const taskListener = {
    flyIt: (name: string) => scenarios.choose(name),
    offer: (pair: PairOffer) => pictures.offers.offer(pair),
  };
  const task = new Task(desk, controllers.inHand, taskListener, scenarios.script);
  const light = lightControl(desk, pictures);
  const [handOverParts, nameField] = [handOver(transmit), naming(keeper, transmit)];
  const { appearance } = pictures;
  const calm = new Calm(welcome, keeper);
  const readiness = new ReadinessNotice();
  const railParts = {
    tones,
    light,
    scenarios,
    appearance,
    naming: nameField,
    ask: handOverParts.ask,
    guide: task.key,
    full: calm.key,
    compiling: readiness.compiling,
  };
  const topRail: Rail = rail(desk, drawing.software && drawing.quality === 'low', railParts, {
    units: () => operations.changeUnits(),
    restart: () => operations.send({ type: 'restart' }),
    keys: () => keys.toggle(),
    controllers: () => operations.openControllers(),
    console: () => typewriter.toggle(),
  });
  const parts: Parts = {
    ...{
      welcome,
      units,
      arrivals,
      latency,
      control,
      log,
      operator,
      cameraHand,
      devices,
      pictures,
      polygons,
      windows,
    },
    ...{ tones, spine, groups, light, controlPage, keys, scenarios, sheet, task },
    calm,
    console: typewriter,
    ...{ rail: topRail, naming: nameField, handOver: handOverParts },
    pairNotice: notice,
    readiness,
    opening: new Opening(welcome, keeper, controllers.inHand, pictures.monitors.both[1].element),
    freshness: new Freshness(arrivals, pictures, (text, level) => log.say(text, 'camera', level)),
    report: new Report(transmit),
    sounds: new Sounds(tones, spine),
    swap: swapQuestion(controllers.pads),
    touch: touchView(controllers.touch, controllers.pulses),
  };
  const operations: Operations = new Operations(root, parts, transmit);
  return parts;
}

/** Returns a line of the log that names the keys of the sticks. It uses the mapping at the time when the page opens. */
function keysHint(): string {
  const list = (uses: string) => {
    const names = uses.split(' ').map(keyOf);
    return names.join(names.every(({ length }) => length === 1) ? '' : ' ');
  };
  return `${list(MOVE)} move, ${list(TURN)} turn, ? all keys`;
}

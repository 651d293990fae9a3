/** The parts of the operator's page, made by `build.ts`. */

import type { Pictures } from '../cameras/pictures';
import type { CameraHand } from '../input/camera-hand';
import type { Arrivals } from '../link/arrivals';
import type { Latency } from '../link/latency';
import type { PolygonPictures } from '../link/polygon-pictures';
import type { Welcome } from '../link/protocol';
import type { Calm } from '../panel/calm/calm';
import type { Console } from '../panel/console/console';
import type { ControllersSheet } from '../panel/controllers/controllers';
import type { KeyMap } from '../panel/controllers/key-map';
import type { SwapQuestion } from '../panel/controllers/swap';
import type { TouchView } from '../panel/controllers/touch-sticks';
import type { Groups } from '../panel/desk/desk';
import type { PairNotice } from '../panel/monitors/pair-notice';
import type { HandOver } from '../panel/rail/hand-over';
import type { LightControl } from '../panel/rail/light';
import type { Naming } from '../panel/rail/naming';
import type { Rail } from '../panel/rail/rail';
import type { ScenarioChoice } from '../panel/rail/scenarios';
import type { Spine } from '../panel/spine/spine';
import type { ControlPage } from '../panel/target/control-page';
import type { Task } from '../task';
import type { ShownUnits } from '../words/units';
import type { Control } from './control';
import type { DeviceWatch } from './device-watch';
import type { Freshness } from './freshness';
import type { Log } from './log';
import type { Opening } from './opening';
import type { Operator } from './operator';
import type { ReadinessNotice } from './readiness';
import type { Report } from './report';
import type { Sounds } from './sounds';
import type { Tones } from './tones';
import type { WindowLink } from './window-link';

export interface Parts {
  readonly welcome: Welcome;
  readonly units: ShownUnits;
  // messages from and to the station
  readonly arrivals: Arrivals;
  readonly latency: Latency;
  readonly control: Control;
  readonly log: Log;
  readonly report: Report;
  // the operator's devices
  readonly operator: Operator;
  readonly cameraHand: CameraHand;
  readonly devices: DeviceWatch;
  // pictures, secondary windows and sounds
  readonly pictures: Pictures;
  readonly freshness: Freshness;
  readonly polygons: PolygonPictures;
  readonly windows: WindowLink;
  readonly tones: Tones;
  readonly sounds: Sounds;
  // spine, desk and rail
  readonly spine: Spine;
  readonly groups: Groups;
  readonly rail: Rail;
  readonly light: LightControl;
  readonly calm: Calm;
  readonly naming: Naming;
  // sheets, questions and other elements over the page
  readonly controlPage: ControlPage;
  readonly console: Console;
  readonly handOver: HandOver;
  readonly keys: KeyMap;
  readonly scenarios: ScenarioChoice;
  readonly sheet: ControllersSheet;
  readonly swap: SwapQuestion;
  readonly touch: TouchView;
  readonly task: Task;
  readonly pairNotice: PairNotice;
  readonly readiness: ReadinessNotice;
  readonly opening: Opening;
}

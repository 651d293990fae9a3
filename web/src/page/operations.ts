/** Effects of keys, buttons and lamps on the station and on the page. The effects of the sticks are not included. */

import type { Action } from '../input/action';
import { perform } from '../input/keymap';
import type { Acting } from '../input/uses/acting';
import type { Frame } from '../link/protocol';
import type { Command } from '../link/socket';
import { setClass } from '../panel/parts/dom';
import { outline } from '../panel/spine/concerns';
import { LAMPS, type LampName } from '../panel/spine/lamps';
import { BLOCKED, type Torn, tearOff } from '../windows/opened';
import type { Parts } from './parts';

const RIGID = 'Nothing bends: the plant is not flexible.';
const OBSERVING = 'Observing: only the operator can do that.';

export class Operations implements Acting {
  readonly pictures: Parts['pictures'];
  readonly groups: Parts['groups'];
  readonly light: Parts['light'];
  readonly controlPage: Parts['controlPage'];
  readonly console: Parts['console'];

  constructor(
    private readonly root: HTMLElement,
    private readonly parts: Parts,
    private readonly transmit: (command: Command) => number,
  ) {
    this.pictures = parts.pictures;
    this.groups = parts.groups;
    this.light = parts.light;
    this.controlPage = parts.controlPage;
    this.console = parts.console;
  }

  get frame(): Frame | null {
    return this.parts.arrivals.telemetry;
  }

  /** Sends a command if this page is in control; otherwise logs that only the operator can do that. */
  send(command: Command): void {
    const { control, log } = this.parts;
    if (control.role.flying) {
      if (command.type === 'initialise') this.parts.pictures.offers.reopen();
      this.transmit(command);
    } else log.say(OBSERVING);
  }

  acknowledge(): void {
    this.parts.operator.controllers.acknowledge();
    this.parts.spine.acknowledge();
  }

  /** Shows only the log lines that belong to the pressed lamp, and outlines the elements to which the lamp refers. */
  explain(lamp: LampName): void {
    const concern = LAMPS[lamp];
    this.parts.log.keepTo(lamp, concern.kinds);
    outline(concern);
  }

  /** Sends STOP if this page is in control. In MASTER it also sets the master arm to the arm's angles. */
  stop(): void {
    const { control, arrivals, groups, welcome } = this.parts;
    if (!control.role.flying) return;
    this.transmit({ type: 'stop' });
    const entered = arrivals.telemetry?.mode;
    const mode = welcome.modes.find(({ position }) => position === entered);
    if (mode?.kind === 'master') groups.meetMaster();
  }

  /** Switches PULSE on or off for all devices of this page. */
  togglePulse(): void {
    const { pulses } = this.parts.operator.controllers;
    pulses.on = !pulses.on;
  }

  changeUnits(): void {
    this.parts.units.toggle();
    this.parts.windows.update();
  }

  /** Opens the sheet of controllers in place of the key map. */
  openControllers(): void {
    this.parts.keys.close();
    this.parts.sheet.open();
  }

  /** Shows or hides the separating plane. */
  togglePlane(): void {
    const { groups, pictures, windows } = this.parts;
    groups.setPlane(pictures.togglePlane());
    windows.update();
  }

  /** Draws bending exaggerated, or as it is. */
  toggleBending(): void {
    const { groups, log, pictures, welcome, windows } = this.parts;
    if (welcome.flexures.length === 0) log.say(RIGID);
    else groups.setBending(pictures.toggleBending());
    windows.update();
  }

  /** Shows all cameras in place of monitors and desk; clearance and lamps stay visible. */
  showMatrix(on: boolean): void {
    setClass(this.root, 'all-cameras', on);
    const { matrix } = this.parts.pictures;
    if (on) matrix.open(this.root.querySelector('.desk > .clearance'), this.parts.spine.element);
    else matrix.close();
  }

  /** Opens a secondary window. */
  tearOff(what: Torn): void {
    if (!tearOff(what)) this.parts.log.say(BLOCKED);
  }

  /** Assigns the THC to the orbiter (`on`) or to the arm. Without a payload in the worksite, ignores `on`. */
  flyOrbiter(on: boolean): void {
    const { control, log, operator, welcome } = this.parts;
    if (!control.role.flying) log.say(OBSERVING);
    else operator.sticks.flyOrbiter(on && welcome.work.cargo.length > 0);
  }

  /** Reason why camera switches have no effect, in a sentence; empty if they have an effect. */
  cameraBar(): string {
    const { operator, arrivals } = this.parts;
    if (!operator.flying) return 'Observing: only the operator can move cameras.';
    const autopilot = arrivals.telemetry?.display.autopilot ?? null;
    return autopilot === null
      ? ''
      : `The ${autopilot} is in control: move a stick to take over, then turn cameras.`;
  }

  /** Assigns the THC to the orbiter, or to the arm. */
  swapOrbiter(): void {
    this.flyOrbiter(!this.parts.operator.sticks.flyingOrbiter);
  }

  enterMode(): void {
    if (!this.groups.mode.enter()) this.parts.task.enterMode();
  }

  mute(): void {
    const { tones } = this.parts;
    tones.set({ muted: !tones.muted });
  }

  /** Closes all sheets and lists, and leaves the control in focus. */
  leave(): void {
    const { keys, controlPage, console, sheet, rail } = this.parts;
    for (const each of [keys, controlPage, console, sheet, rail]) each.close();
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
  }

  act(action: Action): void {
    const { calm, keys } = this.parts;
    calm.use(action.name === 'grip' ? action.grip : action.name);
    if (action.name === 'grip') this.groups.grip(action);
    else if (action.name === 'keys') keys.toggle();
    else perform(action.name, this);
  }
}

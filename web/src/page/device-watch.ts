/** Reports the devices in use to the station, lost devices to the station and to the page's log, faults to the log. */

import type { Controllers } from '../input/controllers';
import type { Level } from '../link/protocol';
import type { Command } from '../link/socket';

const REMEDY = 'Plug it in again, or move another device';
const FAULT_REMEDY = 'Plug it in again, or assign another axis in Controllers';

export interface DeviceWatchListener {
  send(command: Command): void;
  /** Adds a line to the log. */
  say(text: string, level: Level): void;
}

export class DeviceWatch {
  /** `Controllers.revision` at the last report to the station; empty if a report is required. */
  private sentRevision = '';
  /** Names of the lost devices at the last call. */
  private lost: ReadonlySet<string> = new Set();
  /** Faults that were logged since their device was connected: a fault that comes and goes is logged once. */
  private readonly told = new Set<string>();

  constructor(
    private readonly controllers: Controllers,
    private readonly listener: DeviceWatchListener,
  ) {}

  /** Lets the next call of `watch` report the devices again, because the station may have lost its copy. */
  reportAgain(): void {
    this.sentRevision = '';
  }

  /**
   * Checks the devices. If a device was lost and this page is in control, sends `hands_off` to the station, which then
   * holds position.
   *
   * @param ours whether this page is in control.
   * @param flying whether this page is in control and its sticks move the arm.
   */
  watch(ours: boolean, flying: boolean): void {
    const { controllers, listener } = this;
    const lost = new Set(controllers.lost.map(({ short }) => short));
    const newlyLost = [...lost].filter((short) => !this.lost.has(short));
    if (newlyLost.length > 0 && ours) listener.send({ type: 'hands_off', cause: 'device lost' });
    for (const short of newlyLost) listener.say(`${short} lost: sticks at zero. ${REMEDY}`, 'caution');
    for (const short of this.lost) if (!lost.has(short)) listener.say(`${short}: loss cleared`, 'info');
    this.lost = lost;
    for (const fault of this.told)
      if (newlyLost.some((short) => fault.startsWith(`${short}: `))) this.told.delete(fault);
    for (const fault of controllers.faults) {
      if (!this.told.has(fault)) listener.say(`${fault}. ${FAULT_REMEDY}`, 'caution');
      this.told.add(fault);
    }
    const { revision } = controllers;
    if (!flying || revision === this.sentRevision) return;
    this.sentRevision = revision;
    listener.send({ type: 'controllers', controllers: controllers.inUse() });
  }
}

/** Reports the devices in use and lost devices to the station and to the log. */

import type { Controllers } from '../input/controllers';
import type { Level } from '../link/protocol';
import type { Command } from '../link/socket';

export interface DeviceWatchListener {
  send(command: Command): void;
  /** Adds a line to the log. */
  say(text: string, level: Level): void;
}

export class DeviceWatch {
  /** Devices that were last reported to the station. */
  private sentRevision = '';
  /** Names of the lost devices at the last call. */
  private lost: ReadonlySet<string> = new Set();

  constructor(
    private readonly controllers: Controllers,
    private readonly listener: DeviceWatchListener,
  ) {}

  /** Report the devices again: the station has lost its copy. */
  tellAgain(): void {
    this.sentRevision = '';
  }

  /**
   * Checks the devices; if one is lost, the station holds position.
   *
   * @param ours whether this page is in control.
   * @param flying whether its sticks also move the arm.
   */
  watch(ours: boolean, flying: boolean): void {
    const { controllers, listener } = this;
    const lost = new Set(controllers.lost.map(({ short }) => short));
    const gone = [...lost].filter((short) => !this.lost.has(short));
    if (gone.length > 0 && ours) listener.send({ type: 'hands_off', cause: 'device lost' });
    for (const short of gone) listener.say(`${short} is gone: sticks at zero`, 'caution');
    for (const short of this.lost) if (!lost.has(short)) listener.say(`${short}: loss cleared`, 'info');
    this.lost = lost;
    const { revision } = controllers;
    if (!flying || revision === this.sentRevision) return;
    this.sentRevision = revision;
    listener.send({ type: 'controllers', controllers: controllers.inUse() });
  }
}

/** Tells the station what is flown with, and that a device is gone or back. */

import type { Controllers } from '../input/controllers';
import type { Level } from '../link/protocol';
import type { Command } from '../link/socket';

export interface DeviceWatchListener {
  send(command: Command): void;
  /** A line of the log. */
  say(text: string, level: Level): void;
}

export class DeviceWatch {
  /** Devices that were last reported to the station. */
  private told = '';
  /** The devices that were gone, by name. */
  private lost: ReadonlySet<string> = new Set();

  constructor(
    private readonly controllers: Controllers,
    private readonly listener: DeviceWatchListener,
  ) {}

  /** Report the devices again: the station has lost its copy. */
  tellAgain(): void {
    this.told = '';
  }

  /**
   * Looks at the devices; where one is gone, position is held.
   *
   * @param ours the flight is this page's.
   * @param flying and it flies: nothing keeps its sticks from it.
   */
  watch(ours: boolean, flying: boolean): void {
    const { controllers, listener } = this;
    const lost = new Set(controllers.lost.map(({ short }) => short));
    const gone = [...lost].filter((short) => !this.lost.has(short));
    if (gone.length > 0 && ours) listener.send({ type: 'hands_off', cause: 'device lost' });
    for (const short of gone) listener.say(`${short} is gone: sticks at zero`, 'caution');
    for (const short of this.lost) if (!lost.has(short)) listener.say(`${short} is no longer missed`, 'info');
    this.lost = lost;
    const { revision } = controllers;
    if (!flying || revision === this.told) return;
    this.told = revision;
    listener.send({ type: 'controllers', controllers: controllers.told() });
  }
}

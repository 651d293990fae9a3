/** Link to the secondary windows of a replay. They receive cameras and playhead; their keys act on the page. */

import type { Pictures } from '../cameras/pictures';
import { RelayedKeys } from '../input/key-relay';
import { pageName } from '../link/identity';
import type { Camera } from '../link/protocol';
import { type WindowMessage, Windows } from '../windows/opened';
import type { UnitName } from '../words/units';
import type { Player } from './player';

export class ReplayWindows {
  private readonly windows = new Windows(pageName(), (message) => this.hear(message));
  private readonly relayed = new RelayedKeys(() => {});
  private sentHead = '';

  constructor(
    private readonly player: Player,
    private readonly pictures: Pictures,
    private readonly cameras: readonly Camera[],
    private readonly units: () => UnitName,
  ) {
    window.addEventListener('pagehide', () => this.windows.say({ kind: 'gone' }));
  }

  /** Sends the page's state to the windows: cameras, separating plane, bending and units. */
  tell(): void {
    const { showsPlane: plane, exaggerates: bending } = this.pictures;
    const { shown: monitors } = this.pictures.monitors;
    this.windows.say({ kind: 'page', monitors, plane, bending, units: this.units(), takesKeys: true });
  }

  /** Sends the playhead if it has changed since the last message. */
  tellHead(): void {
    const { position, speed } = this.player;
    const head = `${position} ${speed}`;
    if (head === this.sentHead) return;
    this.sentHead = head;
    this.windows.say({ kind: 'head', position, speed });
  }

  private hear(message: WindowMessage): void {
    switch (message.kind) {
      case 'ask':
        this.tell();
        this.sentHead = '';
        this.tellHead();
        break;
      case 'seek':
        this.player.seek(message.position);
        break;
      case 'take':
        if (this.pictures.monitors.hand !== this.pictures.monitors.both[message.monitor])
          this.pictures.monitors.take(message.monitor);
        break;
      case 'show':
        this.pictures.monitors.show(message.monitor, message.names);
        break;
      case 'put': {
        const camera = this.cameras.find(({ name }) => name === message.name);
        if (camera) this.pictures.monitors.choose(camera);
        break;
      }
      case 'key':
      case 'holding':
      case 'released':
        this.relayed.take(message);
        break;
    }
  }
}

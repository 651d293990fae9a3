/** Secondary windows of a replay: they receive its pictures and playhead, and control it. */

import type { Pictures } from '../cameras/pictures';
import { RelayedKeys } from '../input/key-relay';
import { pageName } from '../link/identity';
import type { Camera } from '../link/protocol';
import { type Said, Windows } from '../windows/opened';
import type { UnitName } from '../words/units';
import type { Player } from './player';

export class ReplayWindows {
  private readonly windows = new Windows(pageName(), (said) => this.hear(said));
  private readonly relayed = new RelayedKeys(() => {});
  private told = '';

  constructor(
    private readonly player: Player,
    private readonly pictures: Pictures,
    private readonly cameras: readonly Camera[],
    private readonly units: () => UnitName,
  ) {
    window.addEventListener('pagehide', () => this.windows.say({ kind: 'gone' }));
  }

  /** Sends the windows the page's cameras, plane and units. */
  tell(): void {
    const { showsPlane: plane } = this.pictures;
    const { shown: monitors } = this.pictures.monitors;
    this.windows.say({ kind: 'page', monitors, plane, units: this.units(), takesKeys: true });
  }

  /** Sends the playhead if it has changed since the last message. */
  tellHead(): void {
    const { position, speed } = this.player;
    const head = `${position} ${speed}`;
    if (head === this.told) return;
    this.told = head;
    this.windows.say({ kind: 'head', position, speed });
  }

  private hear(said: Said): void {
    switch (said.kind) {
      case 'ask':
        this.tell();
        this.told = '';
        this.tellHead();
        break;
      case 'seek':
        this.player.seek(said.position);
        break;
      case 'take':
        if (this.pictures.monitors.hand !== this.pictures.monitors.both[said.monitor])
          this.pictures.monitors.take(said.monitor);
        break;
      case 'show':
        this.pictures.monitors.show(said.monitor, said.names);
        break;
      case 'put': {
        const camera = this.cameras.find(({ name }) => name === said.name);
        if (camera) this.pictures.monitors.choose(camera);
        break;
      }
      case 'key':
      case 'holding':
      case 'released':
        this.relayed.take(said);
        break;
    }
  }
}

/** The page's secondary windows: they follow the page, and their keys act in it while it is in control. */

import type { Pictures } from '../cameras/pictures';
import { RelayedKeys } from '../input/key-relay';
import { pageName } from '../link/identity';
import type { Welcome } from '../link/protocol';
import { Windows } from '../windows/opened';
import type { UnitName } from '../words/units';
import type { Control } from './control';

export class WindowLink {
  private readonly windows: Windows;
  private readonly relayed: RelayedKeys;

  constructor(
    welcome: Welcome,
    private readonly pictures: Pictures,
    private readonly control: Control,
    private readonly units: () => UnitName,
    centreSticks: () => void,
  ) {
    this.relayed = new RelayedKeys(centreSticks);
    this.windows = new Windows(pageName(), (said) => {
      const { role } = this.control;
      if (said.kind === 'ask') this.update();
      else if (said.kind === 'show') pictures.monitors.show(said.monitor, said.names);
      else if (said.kind === 'put') {
        const camera = welcome.cameras.find(({ name }) => name === said.name);
        if (camera) pictures.monitors.choose(camera);
      } else if (said.kind === 'take') {
        const { monitors } = pictures;
        if (role.flying && monitors.hand !== monitors.both[said.monitor]) monitors.take(said.monitor);
      } else if (said.kind === 'key' || said.kind === 'holding' || said.kind === 'released') {
        if (role.flying) this.relayed.take(said);
      }
    });
  }

  /** Sends the windows the page's cameras, plane, units and role. */
  update(): void {
    const { showsPlane: plane } = this.pictures;
    const { shown: monitors } = this.pictures.monitors;
    const { flying: takesKeys } = this.control.role;
    this.windows.say({ kind: 'page', monitors, plane, units: this.units(), takesKeys });
  }

  /** Tells the windows that the page closes. */
  gone(): void {
    this.windows.say({ kind: 'gone' });
  }

  dispose(): void {
    this.relayed.dispose();
    this.windows.dispose();
  }
}

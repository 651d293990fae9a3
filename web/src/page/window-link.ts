/**
 * Link to the page's secondary windows, which show the page's state. While the page is in control, keys pressed in
 * these windows act on the page.
 */

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
    this.windows = new Windows(pageName(), (message) => {
      const { role } = this.control;
      if (message.kind === 'ask') this.update();
      else if (message.kind === 'show') pictures.monitors.show(message.monitor, message.names);
      else if (message.kind === 'put') {
        const camera = welcome.cameras.find(({ name }) => name === message.name);
        if (camera) pictures.monitors.choose(camera);
      } else if (message.kind === 'take') {
        const { monitors } = pictures;
        if (role.flying && monitors.hand !== monitors.both[message.monitor]) monitors.take(message.monitor);
      } else if (message.kind === 'key' || message.kind === 'holding' || message.kind === 'released') {
        if (role.flying) this.relayed.take(message);
      }
    });
  }

  /**
   * Tells the windows which cameras the monitors show, whether the separating plane is visible, the units, and whether
   * keys pressed in the windows act on the page.
   */
  update(): void {
    const { showsPlane: plane, exaggerates: bending } = this.pictures;
    const { shown: monitors } = this.pictures.monitors;
    const { flying: takesKeys } = this.control.role;
    this.windows.say({ kind: 'page', monitors, plane, bending, units: this.units(), takesKeys });
  }

  /** Tells the windows that the page is closing. */
  gone(): void {
    this.windows.say({ kind: 'gone' });
  }

  dispose(): void {
    this.relayed.dispose();
    this.windows.dispose();
  }
}

/** Buttons that select the device that the sheet shows. */

import type { Controllers } from '../../input/controllers';
import type { Kind } from '../../input/mapping';
import { button, el, setPressed } from '../parts/dom';

const NAMES: Readonly<Record<Kind, string>> = {
  keyboard: 'Keyboard',
  pad: 'Pad',
  'thc pad': 'THC pad',
  'rhc pad': 'RHC pad',
  'thc joystick': 'THC joystick',
  'rhc joystick': 'RHC joystick',
  spacemouse: 'SpaceMouse',
  touch: 'Touch sticks',
};

export class Choices {
  readonly element = el('div', { class: 'choices-of-device', role: 'group', 'aria-label': 'Device' });
  private drawn = '';

  constructor(private readonly chosen: (kind: Kind) => void) {}

  /** Shows the connected devices, and the kinds of device that can be connected. */
  show(controllers: Controllers, present: Kind): void {
    const pads = controllers.pads.devices.map(({ kind }) => kind);
    const kinds: readonly Kind[] = [
      'keyboard',
      ...(pads.length > 0 ? pads : ['pad' as const]),
      'spacemouse',
      'touch',
    ];
    const signature = `${kinds} ${present}`;
    if (signature === this.drawn) return;
    const focused = this.element.contains(document.activeElement);
    this.drawn = signature;
    const keys = kinds.map((kind) => {
      const key = button({}, [NAMES[kind]], () => this.chosen(kind));
      setPressed(key, kind === present);
      return key;
    });
    this.element.replaceChildren(...keys);
    if (focused) keys[kinds.indexOf(present)]?.focus();
    if (!kinds.includes(present)) this.chosen(kinds[1] ?? 'keyboard');
  }
}

/** Volume and mute of the station's tones, in the rail. */

import type { Tones } from '../../page/tones';
import { button, el, setPressed, setText } from '../parts/dom';

export interface Sound {
  readonly element: HTMLElement;
  values(): void;
}

export function sound(tones: Tones): Sound {
  const mute = button(
    { class: 'mute', title: 'Switch the sounds of alarms, captures, modes, motors and latches on or off' },
    [],
    () => tones.set({ muted: !tones.muted }),
  );
  const volume = el('input', {
    type: 'range',
    class: 'volume',
    'data-calm': 'full',
    min: '0',
    max: '1',
    step: '0.05',
    value: String(tones.volume),
    'aria-label': 'Volume of the tones',
  });
  volume.addEventListener('input', () => tones.set({ volume: Number(volume.value), muted: false }));
  return {
    element: el('span', { class: 'sound' }, mute, volume),
    values() {
      setPressed(mute, tones.muted);
      setText(mute, tones.muted ? 'Muted' : 'Tones');
    },
  };
}

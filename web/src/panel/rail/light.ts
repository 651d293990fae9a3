/** Key that opens the list “Light”, and this list: sun and Earth, lamps, exposure lock, and early television. */

import type { Names } from '../../input/active-device';
import type { Camera, Frame, Lighting } from '../../link/protocol';
import type { Appearance } from '../../page/appearance';
import { button, el, setAttribute, setPressed, setText } from '../parts/dom';
import { dropDown } from '../parts/drop-down';
import type { Desk } from '../parts/part';

export interface LightControl {
  readonly element: HTMLElement;
  /** `names`: those of the device in use. */
  values(frame: Frame, names: Names): void;
  /** Opens the list, with the focus on its first key, or closes it. */
  toggle(): void;
  /** Locks the exposure of the selected picture, or unlocks it. */
  lock(): void;
  close(): void;
}

/** Pictures on which the exposure lock acts. */
export interface Exposed {
  /** Monitors with the selected camera. */
  readonly monitors: { readonly camera: Camera };
  readonly appearance: Appearance;
  /** Present exposure of a camera's picture [photographic stops above the exposure for full sunlight]. */
  stops(camera: Camera): number;
}

export function lightControl({ welcome, send }: Desk, exposed: Exposed): LightControl {
  let lighting: Lighting = { condition: '', lamps: [], locked: [] };
  const set = (change: Partial<Lighting>) => {
    lighting = { ...lighting, ...change };
    send({ type: 'set_light', lighting });
  };
  const conditions = welcome.conditions.map(({ name, source }) =>
    button({ title: source }, [name], () => set({ condition: name })),
  );
  const lamps = welcome.lamps.map((name) =>
    button({}, [name], () => set({ lamps: toggled(welcome.lamps, lighting.lamps, name) })),
  );
  const lockKey = button({}, [], () => lock());
  const { appearance } = exposed;
  const early = button({ title: EARLY }, ['early flights'], () =>
    appearance.set({ early: !appearance.early }),
  );
  const list = el(
    'div',
    { class: 'choices light', role: 'group', 'aria-label': 'Light' },
    el('div', { role: 'group', 'aria-label': 'Sun and Earth' }, el('h3', {}, 'Sun and Earth'), ...conditions),
    el(
      'div',
      { role: 'group', 'aria-label': 'Lamps' },
      ...(lamps.length > 0 ? [el('h3', {}, 'Lamps'), ...lamps] : []),
      el('h3', {}, 'Exposure'),
      lockKey,
      el('h3', {}, 'Television'),
      early,
    ),
  );
  const drop = dropDown('Light', '', list);
  const lock = () => {
    const { camera } = exposed.monitors;
    const others = lighting.locked.filter((each) => each.camera !== camera.name);
    const locked = others.length < lighting.locked.length;
    set({ locked: locked ? others : [...others, { camera: camera.name, stops: exposed.stops(camera) }] });
  };

  return {
    element: drop.element,
    values(frame, names) {
      lighting = frame.display.lighting;
      setAttribute(drop.key, 'title', `Set sun, lamps and exposure: ${names.name('light')}`);
      setAttribute(
        lockKey,
        'title',
        `Lock the exposure of the selected picture: ${names.name('lock exposure')}`,
      );
      conditions.forEach((each, i) => {
        setPressed(each, welcome.conditions[i]?.name === lighting.condition);
      });
      lamps.forEach((each, i) => {
        setPressed(each, lighting.lamps.includes(welcome.lamps[i] ?? ''));
      });
      const { name } = exposed.monitors.camera;
      setText(lockKey, `lock ${name}`);
      setPressed(
        lockKey,
        lighting.locked.some(({ camera }) => camera === name),
      );
      setPressed(early, appearance.early);
    },
    toggle() {
      drop.open(!drop.isOpen);
      if (drop.isOpen) conditions[0]?.focus();
      else drop.key.blur();
    },
    lock,
    close: () => drop.open(false),
  };
}

const EARLY = 'Show all television cameras in black and white, with noise, in this browser';

/** Returns the lamps that are on after the lamp `name` was switched, in the order of `all`. */
export function toggled(all: readonly string[], on: readonly string[], name: string): readonly string[] {
  return all.filter((each) => (each === name ? !on.includes(each) : on.includes(each)));
}

/** Translation and velocity of the orbiter, relative to the bodies that do not move with the orbiter. */

import type { Display, Vec3 } from '../../link/protocol';
import { fixed } from '../../words/format';
import type { Units } from '../../words/units';
import { el, setText } from '../parts/dom';

/** Below this speed the orbiter counts as at rest [m/s]. */
const REST = 1e-4;
const AXES = ['fwd', 'stbd', 'down'] as const;
const FOOT = 0.3048;

export interface OrbiterReading {
  readonly element: HTMLElement;
  set(display: Display, units: Units): void;
}

export function orbiterReading(): OrbiterReading {
  const [moved, speed] = [line(), line()];
  const element = el(
    'dl',
    { class: 'orbiter' },
    el('dt', {}, ''),
    ...AXES.map((name) => el('dt', {}, name)),
    moved.unit,
    ...moved.cells,
    speed.unit,
    ...speed.cells,
  );
  return {
    element,
    set({ orbiter, orbiter_velocity }, units) {
      const feet = units.name === 'ft-in';
      const per = feet ? 1 / FOOT : 1;
      moved.set(orbiter, per, feet ? 'ft' : 'm', feet ? 1 : 2);
      speed.set(orbiter_velocity, per, feet ? 'ft/s' : 'm/s', 2);
    },
  };
}

export function isMoving({ orbiter_velocity }: Pick<Display, 'orbiter_velocity'>): boolean {
  return Math.hypot(...orbiter_velocity) > REST;
}

function line() {
  const unit = el('dt');
  const cells = AXES.map(() => el('dd'));
  return {
    unit,
    cells,
    set(values: Vec3, per: number, name: string, decimals: number) {
      setText(unit, name);
      cells.forEach((cell, i) => {
        setText(cell, fixed((values[i] ?? 0) * per, decimals));
      });
    },
  };
}

/**
 * The vector from the empty snares to the grapple pin, in components along the axes of the sticks. Beside each
 * component is the key, button or axis that moves the end effector towards the pin.
 */

import type { Names } from '../../input/active-device';
import type { Vec3 } from '../../link/protocol';
import { small } from '../../words/format';
import type { Units } from '../../words/units';
import { el, setAttribute, setText } from '../parts/dom';

/** A component smaller than this needs no motion [m]. */
const LEAST = 0.005;
const AXES = ['X', 'Y', 'Z'] as const;

export interface WayPart {
  /** Axis and direction of the stick, such as `−Z`. */
  readonly stick: string;
  /** Key, button or axis; empty if no motion is needed. */
  readonly handle: string;
  readonly value: string;
}

export function wayParts(way: Vec3, { gap }: Units, names: Names): readonly WayPart[] {
  return AXES.map((axis, i) => {
    const length = way[i] ?? 0;
    const value = small(Math.abs(length), gap);
    if (Math.abs(length) < LEAST) return { stick: axis, handle: '', value };
    const [sign, use] = length > 0 ? ['+', `+${axis}`] : ['−', `-${axis}`];
    return { stick: sign + axis, handle: names.short(use), value };
  });
}

export function wayToFixture() {
  const rows = AXES.map(() => ({ stick: el('span'), handle: el('b'), value: el('span') }));
  const head = el('span', { class: 'head' });
  const element = el(
    'li',
    { class: 'way' },
    head,
    ...rows.map(({ stick, handle, value }) => el('div', {}, stick, handle, value)),
  );
  return {
    element,
    set(way: Vec3 | null, units: Units, names: Names) {
      element.hidden = way === null;
      if (!way) return;
      setText(head, `to pin, ${units.gap.name}`);
      const parts = wayParts(way, units, names);
      rows.forEach(({ stick, handle, value }, i) => {
        setText(stick, parts[i]?.stick ?? '');
        setText(handle, parts[i]?.handle ?? '');
        setText(value, parts[i]?.value ?? '');
      });
      setAttribute(element, 'title', description(parts, units));
    },
  };
}

function description(parts: readonly WayPart[], { gap }: Units): string {
  const flown = parts.filter(({ handle }) => handle !== '');
  const words = flown
    .map(({ stick, handle, value }) => `${stick} (${handle}) ${value} ${gap.name}`)
    .join(', ');
  return `From the end effector to the pin: ${words || 'at the pin'}`;
}

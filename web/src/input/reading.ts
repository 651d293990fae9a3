/** Reading of a device: a check of its numbers, and the deflections that it commands. */

import { clamp } from '../basics/clamp';
import { type Deflection, ZERO } from './deflection';
import { USES } from './keymap';
import { centred, indexOf, type Mapping, shape } from './mapping';

/** Raw reading of a device. */
export interface Reading {
  /** Each in [-1, 1]. */
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly pressed: boolean; readonly value: number }[];
}

/**
 * Returns a reading in which each part that is not a finite number counts as 0, and the sources of these parts. Some
 * drivers report NaN for an axis at rest.
 */
export function checked({ axes, buttons }: Reading): {
  readonly reading: Reading;
  readonly wrong: readonly string[];
} {
  const wrong: string[] = [];
  const number = (value: number, source: string) => {
    if (Number.isFinite(value)) return value;
    wrong.push(source);
    return 0;
  };
  const reading = {
    axes: axes.map((value, i) => number(value, `a${i}`)),
    buttons: buttons.map(({ pressed, value }, i) => ({ pressed, value: number(value, `b${i}`) })),
  };
  return { reading, wrong };
}

/** Returns how far a button is pressed, 0 to 1. Some drivers report only whether it is pressed. */
function travel(reading: Reading, index: number): number {
  const button = reading.buttons[index];
  return button ? button.value || Number(button.pressed) : 0;
}

/**
 * Returns the value of a source before deadband and expo; zero for a button while another held button changes its
 * function.
 */
export function valueAt(reading: Reading, source: string, { bindings, centres }: Mapping): number {
  const axis = indexOf(source, 'a');
  if (axis !== null) return centred(reading.axes[axis] ?? 0, centres[axis] ?? 0);
  const [first, second] = source.split('+').map((part) => Number(part.slice(1)));
  if (second !== undefined) return travel(reading, first ?? 0) > 0.5 ? travel(reading, second) : 0;
  const other = Object.keys(bindings).find(
    (each) => each.endsWith(`+${source}`) && travel(reading, Number(each.split('+')[0]?.slice(1))) > 0.5,
  );
  return other ? 0 : travel(reading, first ?? 0);
}

/**
 * Returns the deflections of a reading, before (`shaped` false) or after deadband and expo; `counts` returns whether an
 * axis or button commands them.
 */
export function deflection(
  reading: Reading,
  mapping: Mapping,
  shaped = true,
  counts: (source: string) => boolean = () => true,
): Deflection {
  const values = ZERO.map(() => 0);
  for (const [source, use] of Object.entries(mapping.bindings)) {
    const does = USES.get(use)?.does;
    if (does?.kind !== 'axis' || !counts(source)) continue;
    const value = valueAt(reading, source, mapping);
    values[does.axis] = (values[does.axis] ?? 0) + does.sign * (shaped ? shape(value, mapping) : value);
  }
  return values.map((value) => clamp(value) + 0);
}

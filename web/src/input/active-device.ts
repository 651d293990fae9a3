/** The device in use (the keyboard, or the device that was moved last), and the names of its keys, buttons and axes. */

import type { Device } from './device';
import type { Keyboard } from './keyboard';
import { keyOf, nameOfSource, shortOfSource } from './layout';
import { assignedParts, centred, indexOf, type Kind } from './mapping';
import { movers, type Source } from './rebind';
import { mappingOf } from './store';

/** Least deflection of an axis that counts as moved. */
const MOVED = 0.3;

/** Name of the key, button or axis direction that has the function `use`; empty if none has it. */
export interface Names {
  name(use: string): string;
  /** The abbreviated name. */
  short(use: string): string;
}

/** Names of the keyboard's keys. */
export const KEYS: Names = { name: keyOf, short: (use) => called(['keyboard'], use, shortOfSource) };

/** Devices that can be in use. */
export interface Movable {
  readonly devices: readonly Device[];
  readonly keyboard: Pick<Keyboard, 'held'>;
}

export class InHand implements Names {
  /** The device moved last; null for the keyboard. */
  device: Device | null = null;

  constructor(private readonly controllers: Movable) {}

  /** Updates `device`. */
  look(): void {
    const { devices, keyboard } = this.controllers;
    const moved = devices.find((device) => device.acts && isMoved(device));
    const kept = devices.find((device) => device === this.device && device.state !== 'lost');
    this.device = moved ?? (keyboard.held.size > 0 ? null : kept) ?? null;
  }

  /** Kinds of device in which a function is looked up: first the device in use, then the others. */
  get kinds(): readonly Kind[] {
    const { device } = this;
    if (!device) return ['keyboard'];
    const others = this.controllers.devices.filter((each) => each !== device && each.acts);
    return [...[device, ...others].map(({ kind }) => kind), 'keyboard'];
  }

  name(use: string): string {
    return called(this.kinds, use, nameOfSource);
  }

  short(use: string): string {
    return called(this.kinds, use, shortOfSource);
  }

  /** Returns whether a key, button or axis with this function is held. */
  holds(use: string): boolean {
    const { devices, keyboard } = this.controllers;
    if (movers(mappingOf('keyboard'), use).some(({ source }) => keyboard.held.has(source))) return true;
    return devices.some((device) =>
      movers(device.mapping, use).some(({ source, sign }) => isDown(device, source, sign)),
    );
  }

  /** Returns the buttons and axes of the device in use that have one of these functions. */
  sources(uses: readonly string[]): ReadonlySet<string> {
    const { device } = this;
    if (!device) return new Set();
    const all = uses.flatMap((use) => movers(device.mapping, use).map(({ source }) => source));
    return new Set(all.flatMap((source) => source.split('+')));
  }
}

/** Returns the name of the key, button or axis direction with this function, on the first of `kinds` that has one. */
function called(
  kinds: readonly Kind[],
  use: string,
  call: (kind: Kind, source: string, sign: Source['sign']) => string,
): string {
  for (const kind of kinds) {
    const [first] = movers(mappingOf(kind), use);
    if (first) return call(kind, first.source, first.sign);
  }
  return '';
}

type Read = Pick<Device, 'reading' | 'mapping' | 'rest'>;

/** Returns whether an assigned axis or button is moved. Unassigned parts do not count: a throttle may rest anywhere. */
function isMoved(device: Read): boolean {
  return [...assignedParts(device.mapping)].some((part) => Math.abs(deflectionOf(device, part)) > MOVED);
}

/** Returns whether a button is pressed, or an axis is deflected to the side `sign`. */
export function isDown(device: Read, source: string, sign: 1 | -1): boolean {
  if (indexOf(source, 'a') !== null) return sign * deflectionOf(device, source) > device.mapping.deadband;
  return source.split('+').every((part) => deflectionOf(device, part) === 1);
}

/**
 * Returns the deflection of an axis from its rest position, 0 if this is not known; for a button, 1 if it is pressed,
 * else 0.
 */
function deflectionOf({ reading, mapping, rest }: Read, part: string): number {
  if (!reading) return 0;
  const axis = indexOf(part, 'a');
  if (axis !== null)
    return rest.knows(part) ? centred(reading.axes[axis] ?? 0, mapping.centres[axis] ?? 0) : 0;
  return reading.buttons[Number(part.slice(1))]?.pressed === true ? 1 : 0;
}

/** What the operator flies with at the moment: keys, or the device that was moved last; and what a use is called there. */

import type { Device } from './device';
import type { Keyboard } from './keyboard';
import { keyOf, nameOfSource, shortOfSource } from './layout';
import { centred, indexOf, type Kind } from './mapping';
import { movers, type Source } from './rebind';
import { mappingOf } from './store';

/** An axis so far from its rest is moved by somebody. */
const MOVED = 0.3;

/** What people call the key, button or end of an axis that has a use; empty where none has. */
export interface Names {
  name(use: string): string;
  /** In a few letters where a device's parts have longer names. */
  short(use: string): string;
}

/** Those of the keyboard. */
export const KEYS: Names = { name: keyOf, short: (use) => called(['keyboard'], use, shortOfSource) };

/** What may be moved: the keys, and devices. */
export interface Movable {
  readonly devices: readonly Device[];
  readonly keyboard: Pick<Keyboard, 'held'>;
}

export class InHand implements Names {
  /** The device moved last; null: the keys. */
  device: Device | null = null;

  constructor(private readonly controllers: Movable) {}

  /** Looks which was moved. */
  look(): void {
    const { devices, keyboard } = this.controllers;
    const moved = devices.find((device) => device.state === 'flying' && isMoved(device));
    const kept = devices.find((device) => device === this.device && device.state !== 'lost');
    this.device = moved ?? (keyboard.held.size > 0 ? null : kept) ?? null;
  }

  /** Kinds of device, the one in hand first; what it cannot do, others can. */
  get kinds(): readonly Kind[] {
    const { device } = this;
    if (!device) return ['keyboard'];
    const others = this.controllers.devices.filter((each) => each !== device && each.state === 'flying');
    return [...[device, ...others].map(({ kind }) => kind), 'keyboard'];
  }

  name(use: string): string {
    return called(this.kinds, use, nameOfSource);
  }

  short(use: string): string {
    return called(this.kinds, use, shortOfSource);
  }

  /** Whether something is held that has this use. */
  holds(use: string): boolean {
    const { devices, keyboard } = this.controllers;
    if (movers(mappingOf('keyboard'), use).some(({ source }) => keyboard.held.has(source))) return true;
    return devices.some((device) =>
      movers(device.mapping, use).some(({ source, sign }) => isDown(device, source, sign)),
    );
  }

  /** Buttons and axes of the device in hand that have one of these uses. */
  sources(uses: readonly string[]): ReadonlySet<string> {
    const { device } = this;
    if (!device) return new Set();
    const all = uses.flatMap((use) => movers(device.mapping, use).map(({ source }) => source));
    return new Set(all.flatMap((source) => source.split('+')));
  }
}

/** What the first of these kinds of device that has a part for a use has it called. */
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

type Read = Pick<Device, 'reading' | 'mapping'>;

/** True if an assigned axis or button is moved; an unassigned throttle may have any position. */
function isMoved(device: Read): boolean {
  const parts = Object.keys(device.mapping.bindings).flatMap((source) => source.split('+'));
  return parts.some((part) => Math.abs(standing(device, part)) > MOVED);
}

/** Whether a button is down, or an axis is off its rest to that side. */
export function isDown(device: Read, source: string, sign: 1 | -1): boolean {
  if (indexOf(source, 'a') !== null) return sign * standing(device, source) > device.mapping.deadband;
  return source.split('+').every((part) => standing(device, part) === 1);
}

/** How far an axis is off its rest; 1 for a button that is down. */
function standing({ reading, mapping }: Read, part: string): number {
  if (!reading) return 0;
  const axis = indexOf(part, 'a');
  if (axis !== null) return centred(reading.axes[axis] ?? 0, mapping.centres[axis] ?? 0);
  return reading.buttons[Number(part.slice(1))]?.pressed === true ? 1 : 0;
}

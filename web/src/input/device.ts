/** One device: conversion of its raw axes and buttons to deflections and actions, and its state. */

import { clamp } from '../basics/clamp';
import { AXES, type Deflection, HANDS, type Hand, isZero, ZERO } from './deflection';
import { type Action, type Grip, USES } from './keymap';
import { centred, indexOf, type Kind, type Mapping, shape } from './mapping';
import { mappingOf } from './store';

/** Raw reading of a device. */
export interface Reading {
  /** Each in [-1, 1]. */
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly pressed: boolean; readonly value: number }[];
}

/** `none`: never seen · `waiting`: not at zero yet · `flying`: in use · `lost`: disconnected while in use. */
export type DeviceState = 'none' | 'waiting' | 'flying' | 'lost';

/** Time without motion after which an axis that is not at zero counts as at rest [ms]. */
const REST_MS = 1500;
/** Changes of an axis below this are noise of its sensor, not motion. */
const STILL = 0.02;

/** Returns how far a button is pressed, 0 to 1. Some drivers report only whether it is pressed. */
function travel(reading: Reading, index: number): number {
  const button = reading.buttons[index];
  return button ? button.value || Number(button.pressed) : 0;
}

/** Value of a source before deadband and expo; zero for a button while another held button changes its function. */
function raw(reading: Reading, source: string, { bindings, centres }: Mapping): number {
  const axis = indexOf(source, 'a');
  if (axis !== null) return centred(reading.axes[axis] ?? 0, centres[axis] ?? 0);
  const [first, second] = source.split('+').map((part) => Number(part.slice(1)));
  if (second !== undefined) return travel(reading, first ?? 0) > 0.5 ? travel(reading, second) : 0;
  const other = Object.keys(bindings).find(
    (each) => each.endsWith(`+${source}`) && travel(reading, Number(each.split('+')[0]?.slice(1))) > 0.5,
  );
  return other ? 0 : travel(reading, first ?? 0);
}

/** Returns the deflections of a reading, before (`shaped` false) or after deadband and expo. */
export function deflection(reading: Reading, mapping: Mapping, shaped = true): Deflection {
  const values = ZERO.map(() => 0);
  for (const [source, use] of Object.entries(mapping.bindings)) {
    const does = USES.get(use)?.does;
    if (does?.kind !== 'axis') continue;
    const value = raw(reading, source, mapping);
    values[does.axis] = (values[does.axis] ?? 0) + does.sign * (shaped ? shape(value, mapping) : value);
  }
  return values.map((value) => clamp(value) + 0);
}

export class Device {
  state: DeviceState = 'none';
  /** The browser's name for the device; empty before it is connected for the first time. */
  name = '';
  /** Present reading; null if the device is not connected. */
  reading: Reading | null = null;
  /**
   * Whether the device is not in use yet and reports a constant value that is not zero. The cause of such a value is an
   * offset of the device's sensor, not a deflection.
   */
  resting = false;
  /** Pressed buttons, each with the function that it had when it was pressed. */
  private readonly down = new Map<number, string | undefined>();
  /**
   * The button that was pressed last, if it can change the functions of other buttons; else null. If it is released
   * before another button is pressed, it performs its own function.
   */
  private alone: number | null = null;
  private still: { axes: readonly number[]; since: number } = { axes: [], since: 0 };

  constructor(
    readonly kind: Kind,
    private readonly acted: (action: Action) => void,
  ) {}

  get mapping(): Mapping {
    return mappingOf(this.kind);
  }

  /** The browser's name without the part in brackets. */
  get short(): string {
    return this.name.replace(/\s*\(.*$/, '').slice(0, 26) || this.kind;
  }

  /** Returns whether the device moves this hand controller. */
  moves(hand: Hand): boolean {
    const axes = HANDS[hand].map((axis) => AXES[axis]);
    return Object.values(this.mapping.bindings).some((use) => axes.some((axis) => axis === use.slice(1)));
  }

  /** Stores the device's reading at `now` [ms] and returns its deflections, which are zero if it is not in use. */
  read(reading: Reading | null, now: number): Deflection {
    this.reading = reading;
    if (!reading) {
      if (this.state !== 'none') this.state = 'lost';
      this.resting = false;
      this.releaseAll();
      return ZERO;
    }
    if (this.state === 'none' || this.state === 'lost') this.wait();
    this.press(reading);
    const value = deflection(reading, this.mapping);
    if (this.state === 'waiting' && isZero(value)) this.state = 'flying';
    if (this.state === 'flying') return value;
    this.watch(reading, now);
    return ZERO;
  }

  /** Centres the device until it has been at zero. A held button acts again only when it is pressed again. */
  disarm(): void {
    if (this.state === 'flying') this.wait();
    for (const [index, use] of this.down) {
      this.down.set(index, undefined);
      this.end(use);
    }
    this.alone = null;
  }

  /** Takes the device out of use; it is not reported as lost. */
  forget(): void {
    this.read(null, 0);
    this.state = 'none';
  }

  private wait(): void {
    this.state = 'waiting';
    this.resting = false;
    this.still = { axes: [], since: 0 };
  }

  private watch({ axes }: Reading, now: number): void {
    const moved = axes.some((value, i) => !(Math.abs(value - (this.still.axes[i] ?? Number.NaN)) < STILL));
    if (moved) this.still = { axes: [...axes], since: now };
    this.resting = !moved && now - this.still.since >= REST_MS;
  }

  private press(reading: Reading): void {
    const { bindings } = this.mapping;
    const changers = new Set(
      Object.keys(bindings)
        .filter((source) => source.includes('+'))
        .map((source) => Number(source.split('+')[0]?.slice(1))),
    );
    const held = [...changers].find((index) => reading.buttons[index]?.pressed);
    for (const [index, { pressed }] of reading.buttons.entries()) {
      if (pressed === this.down.has(index)) continue;
      if (pressed) {
        const chord = held === undefined || held === index ? undefined : bindings[`b${held}+b${index}`];
        const use = chord ?? bindings[`b${index}`];
        this.alone = chord === undefined && changers.has(index) ? index : null;
        this.down.set(index, this.alone !== null ? undefined : use);
        if (this.alone === null) this.begin(use);
      } else {
        const use = this.down.get(index);
        this.down.delete(index);
        this.end(use);
        if (index === this.alone) {
          this.alone = null;
          this.begin(bindings[`b${index}`]);
        }
      }
    }
  }

  private begin(use: string | undefined): void {
    const does = use === undefined ? undefined : USES.get(use)?.does;
    if (does?.kind === 'once') this.acted(does.action);
    else if (does?.kind === 'grip') this.grip(does.grip, true);
  }

  private end(use: string | undefined): void {
    const does = use === undefined ? undefined : USES.get(use)?.does;
    if (does?.kind === 'grip') this.grip(does.grip, false);
  }

  private grip(grip: Grip, down: boolean): void {
    this.acted({ name: 'grip', grip, down, at: performance.now() });
  }

  /** Releases all buttons of a device that is disconnected. */
  private releaseAll(): void {
    const uses = [...this.down.values()];
    this.down.clear();
    this.alone = null;
    for (const use of uses) this.end(use);
  }
}

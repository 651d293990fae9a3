/** One device: conversion of its raw axes and buttons to deflections and actions, and its state. */

import type { Action, Grip } from './action';
import { AXES, type Deflection, HANDS, type Hand, isZero, ZERO } from './deflection';
import { NOT_HELD } from './hold';
import { USES } from './keymap';
import { nameOfSource } from './layout';
import { assignedParts, type Kind, type Mapping } from './mapping';
import { checked, deflection, type Reading } from './reading';
import { zeroed } from './rebind';
import { REST_MS, Rest } from './rest';
import { mappingOf, save } from './store';

/** `none`: never seen · `waiting`: an axis must be centred · `flying`: all axes act · `lost`: disconnected while in use. */
export type DeviceState = 'none' | 'waiting' | 'flying' | 'lost';

/** Changes of an axis below this are noise of its sensor, not motion. */
const STILL = 0.02;

export class Device {
  state: DeviceState = 'none';
  /**
   * Whether the device moves the arm: it has been at zero since it was connected or disarmed. An axis moves the arm once
   * its resting place is known, while the device still waits for others.
   */
  acts = false;
  /** The browser's name for the device; empty before it is connected for the first time. */
  name = '';
  /** Present reading; null if the device is not connected. */
  reading: Reading | null = null;
  /**
   * Whether the device waits, and the axes for which it waits have constant values. The cause of such a value is an
   * offset of the device's sensor, or another resting place, not a deflection.
   */
  resting = false;
  /** Axes and buttons with a function whose values in the present reading are not numbers. */
  private wrong: readonly string[] = [];
  /** Pressed buttons, each with the function that it had when it was pressed. */
  private readonly down = new Map<number, string | undefined>();
  /** Time of the last reading [ms]: a button that is released now was pressed then. */
  private readAt = 0;
  /**
   * The button that was pressed last, if it can change the functions of other buttons; else null. If it is released
   * before another button is pressed, it performs its own function.
   */
  private alone: number | null = null;
  private still: { values: readonly number[]; since: number } = { values: [], since: 0 };

  constructor(
    readonly kind: Kind,
    private readonly acted: (action: Action) => void,
    readonly rest = new Rest(true),
  ) {}

  get mapping(): Mapping {
    return mappingOf(this.kind);
  }

  /** The browser's name without the part in brackets. */
  get short(): string {
    return this.name.replace(/\s*\(.*$/, '').slice(0, 26) || this.kind;
  }

  /** Sentences about axes and buttons that send no numbers now. */
  get faults(): readonly string[] {
    const named = this.wrong.map((source) => nameOfSource(this.kind, source));
    return named.map((name) => `${name} sends no number and counts as 0`);
  }

  /** Returns whether the device moves this hand controller. */
  moves(hand: Hand): boolean {
    const axes = HANDS[hand].map((axis) => AXES[axis]);
    return Object.values(this.mapping.bindings).some((use) => axes.some((axis) => axis === use.slice(1)));
  }

  /** Stores the device's reading at `now` [ms] and returns its deflections, which are zero if it is not in use. */
  read(raw: Reading | null, now: number): Deflection {
    if (!raw) {
      this.reading = null;
      if (this.state !== 'none') this.state = 'lost';
      this.resting = this.acts = false;
      this.wrong = [];
      this.releaseAll();
      return ZERO;
    }
    const { reading, wrong } = checked(raw);
    this.reading = reading;
    this.wrong = wrong.filter((source) => assignedParts(this.mapping).has(source));
    if (this.state === 'none' || this.state === 'lost') this.wait();
    this.press(reading, now);
    this.readAt = now;
    const { rest, mapping } = this;
    rest.look(reading, mapping, now);
    const value = deflection(reading, mapping, true, (source) => rest.knows(source));
    this.acts ||= isZero(value);
    this.state = this.acts && rest.off.length === 0 ? 'flying' : 'waiting';
    if (this.state === 'waiting') this.watch(this.acts ? rest.off : reading.axes, now);
    else this.resting = false;
    return this.acts ? value : ZERO;
  }

  /** Centres the device until it has been at zero. A held button acts again only when it is pressed again. */
  disarm(): void {
    this.acts = false;
    if (this.state === 'flying') this.wait();
    for (const [index, use] of this.down) {
      this.down.set(index, undefined);
      this.end(use, NOT_HELD);
    }
    this.alone = null;
  }

  /** Stores the present positions of the axes as zero; returns the axes that are too far from their centres for this. */
  setZero(): readonly string[] {
    const { mapping, far } = zeroed(this.mapping, this.reading?.axes ?? []);
    save(this.kind, mapping);
    this.rest.set();
    return far;
  }

  /** Takes the device out of use; it is not reported as lost. */
  forget(): void {
    this.read(null, 0);
    this.state = 'none';
  }

  private wait(): void {
    this.state = 'waiting';
    this.resting = false;
    this.still = { values: [], since: 0 };
  }

  private watch(values: readonly number[], now: number): void {
    const moved =
      values.length !== this.still.values.length ||
      values.some((value, i) => !(Math.abs(value - (this.still.values[i] ?? Number.NaN)) < STILL));
    if (moved) this.still = { values: [...values], since: now };
    this.resting = !moved && now - this.still.since >= REST_MS;
  }

  private press(reading: Reading, now: number): void {
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
        if (this.alone === null) this.begin(use, now);
      } else {
        const use = this.down.get(index);
        this.down.delete(index);
        this.end(use, this.readAt);
        if (index === this.alone) {
          this.alone = null;
          this.begin(bindings[`b${index}`], now);
        }
      }
    }
  }

  private begin(use: string | undefined, at: number): void {
    const found = use === undefined ? undefined : USES.get(use);
    if (found?.does.kind === 'grip') this.grip(found.does.grip, true, at);
    else if (found && found.does.kind !== 'axis') this.acted({ name: found.name });
  }

  private end(use: string | undefined, at: number): void {
    const does = use === undefined ? undefined : USES.get(use)?.does;
    if (does?.kind === 'grip') this.grip(does.grip, false, at);
  }

  private grip(grip: Grip, down: boolean, at: number): void {
    this.acted({ name: 'grip', grip, down, at });
  }

  /** Releases all buttons of a device that is disconnected. */
  private releaseAll(): void {
    const uses = [...this.down.values()];
    this.down.clear();
    this.alone = null;
    for (const use of uses) this.end(use, NOT_HELD);
  }
}

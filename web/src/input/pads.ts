/**
 * Gamepads and joysticks: one is both hands; of two the one moved first is the THC, the other one the RHC. A device
 * that nobody has moved flies nothing and is not spoken of.
 */

import { type Deflection, sum, ZERO } from './deflection';
import { Device, type Reading } from './device';
import type { Action } from './keymap';
import type { Kind } from './mapping';

/** An axis that far from where it was first seen was moved by somebody. */
const MOVED = 0.3;
/** Hands. */
const MOST = 2;

interface Seat {
  readonly id: string;
  readonly standard: boolean;
  /** The browser's number for it; another one after it was plugged in again. */
  index: number;
  device: Device;
}

export class Pads {
  /** Two devices fly, and the operator has not yet confirmed which hand each is in. */
  asks = false;
  private seats: Seat[] = [];
  /** What devices not in use showed when they were first seen, by the browser's number. */
  private readonly first = new Map<number, Reading>();

  constructor(private readonly acted: (action: Action) => void) {}

  /** In use: the one for both hands, or THC and RHC. */
  get devices(): readonly Device[] {
    return this.seats.map(({ device }) => device);
  }

  /** Reads all of them at `now` [ms]. */
  poll(now: number): Deflection {
    const there = navigator.getGamepads().filter((pad): pad is Gamepad => pad?.connected === true);
    const free = new Set(there);
    const found = this.seats.map((seat) => {
      const own = there.find(({ id, index }) => id === seat.id && index === seat.index);
      const pad = own ?? there.find((each) => each.id === seat.id && !this.taken(each));
      // Two that come back may have changed places.
      if (pad && seat.device.state === 'lost') this.asks = this.seats.length === MOST;
      if (pad) seat.index = pad.index;
      if (pad) free.delete(pad);
      return pad ?? null;
    });
    for (const index of this.first.keys()) {
      if (![...free].some((pad) => pad.index === index)) this.first.delete(index);
    }
    for (const pad of free) if (this.seats.length < MOST && this.joins(pad)) found.push(pad);
    return sum(ZERO, ...this.seats.map(({ device }, i) => device.read(found[i] ?? null, now)));
  }

  /** The THC's device becomes the RHC's, and the other way round. */
  swap(): void {
    this.seats.reverse();
    this.assign();
    this.asks = false;
  }

  /** Each is in the right hand. */
  keep(): void {
    this.asks = false;
  }

  disarm(): void {
    for (const { device } of this.seats) device.disarm();
  }

  /** The operator knows which are gone; what is left is both hands again. */
  acknowledge(): void {
    const left = this.seats.filter(({ device }) => device.state !== 'lost');
    if (left.length === this.seats.length) return;
    this.seats = left;
    this.asks = false;
    this.assign();
  }

  private taken({ index }: Gamepad): boolean {
    return this.seats.some((seat) => seat.index === index);
  }

  /** Takes a device into use where somebody moved it; a standard pad alone is meant to be used. */
  private joins(pad: Gamepad): boolean {
    const standard = pad.mapping === 'standard';
    const first = this.first.get(pad.index) ?? copied(pad);
    this.first.set(pad.index, first);
    // Some have switches that are always on, and levers that rest anywhere.
    const moved =
      pad.axes.some((value, i) => Math.abs(value - (first.axes[i] ?? 0)) > MOVED) ||
      pad.buttons.some(({ pressed }, i) => pressed !== first.buttons[i]?.pressed);
    if (!moved && !(standard && this.seats.length === 0)) return false;
    const device = new Device('pad', this.acted);
    this.seats.push({ id: pad.id, standard, index: pad.index, device });
    this.first.delete(pad.index);
    this.assign();
    this.asks = this.seats.length === MOST;
    return true;
  }

  /** Gives each its part; whose part has changed must be seen at zero before it flies. */
  private assign(): void {
    this.seats.forEach((seat, i) => {
      const kind = kindOf(seat.standard, this.seats.length === 1 ? null : i === 0 ? 'thc' : 'rhc');
      if (seat.device.kind === kind && seat.device.name !== '') return;
      seat.device.disarm();
      seat.device = new Device(kind, this.acted);
      seat.device.name = seat.id;
    });
  }
}

function copied({ axes, buttons }: Gamepad): Reading {
  return { axes: [...axes], buttons: buttons.map(({ pressed, value }) => ({ pressed, value })) };
}

function kindOf(standard: boolean, hand: 'thc' | 'rhc' | null): Kind {
  if (hand === null) return standard ? 'pad' : 'thc joystick';
  return standard ? `${hand} pad` : `${hand} joystick`;
}

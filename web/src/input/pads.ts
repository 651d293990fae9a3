/**
 * Gamepads and joysticks. A single device is both THC and RHC. Of two devices, the device that was moved first is the
 * THC, and the other is the RHC. A device is used and reported only after it was moved. Exception: if the first device
 * has the standard mapping, it is used at once. A lost device has its place again when it is plugged in again, unless
 * another device was moved first: this one then has the place.
 */

import type { Action } from './action';
import { type Deflection, sum, ZERO } from './deflection';
import { Device } from './device';
import type { Kind } from './mapping';
import { checked, type Reading } from './reading';
import { Rest } from './rest';

/** Least change of an axis from its first position that counts as moved. */
const MOVED = 0.3;
/** Greatest number of devices in use: a THC and an RHC. */
const MOST = 2;

interface Seat {
  readonly id: string;
  readonly standard: boolean;
  /** The browser's number for the device, which may change when the device is plugged in again. */
  index: number;
  /** Present reading; null if the device is not connected. */
  pad: Gamepad | null;
  device: Device;
}

export class Pads {
  /** Whether two devices are in use, and the operator has not confirmed which one is the THC. */
  asks = false;
  private seats: Seat[] = [];
  /** First readings of devices that are not in use, by the browser's number. */
  private readonly first = new Map<number, Reading>();

  constructor(private readonly acted: (action: Action) => void) {}

  /** Devices in use: one device that is both THC and RHC, or first the THC and then the RHC. */
  get devices(): readonly Device[] {
    return this.seats.map(({ device }) => device);
  }

  /** Reads all devices at `now` [ms]. */
  poll(now: number): Deflection {
    const connected = navigator.getGamepads().filter((pad): pad is Gamepad => pad?.connected === true);
    const free = new Set(connected);
    for (const seat of this.seats) {
      const pad = this.padOf(seat, free);
      seat.pad = pad;
      if (!pad) continue;
      // If two devices are plugged in again, the browser may have exchanged them.
      if (seat.device.state === 'lost') this.asks = this.seats.length === MOST;
      seat.index = pad.index;
      free.delete(pad);
    }
    for (const index of this.first.keys()) {
      if (![...free].some((pad) => pad.index === index)) this.first.delete(index);
    }
    for (const pad of free) this.join(pad);
    return sum(ZERO, ...this.seats.map(({ device, pad }) => device.read(pad, now)));
  }

  /** Exchanges the devices of THC and RHC. */
  swap(): void {
    this.seats.reverse();
    this.assign();
    this.asks = false;
  }

  /** Confirms the devices of THC and RHC. */
  keep(): void {
    this.asks = false;
  }

  disarm(): void {
    for (const { device } of this.seats) device.disarm();
  }

  /** Acknowledges lost devices; a remaining device is both THC and RHC again. */
  acknowledge(): void {
    const left = this.seats.filter(({ device }) => device.state !== 'lost');
    if (left.length === this.seats.length) return;
    this.seats = left;
    this.asks = false;
    this.assign();
  }

  /**
   * Returns the device of a place, among devices that have no place yet. When a lost device returns, the browser's number
   * for it may have changed: of two equal devices, the first to return has the place of the THC.
   */
  private padOf(seat: Seat, free: ReadonlySet<Gamepad>): Gamepad | null {
    const equal = [...free].filter(({ id }) => id === seat.id);
    const used = this.seats.filter(({ device }) => device.state !== 'lost').map(({ index }) => index);
    const fits = ({ index }: Gamepad) =>
      seat.device.state === 'lost' ? !used.includes(index) : index === seat.index;
    return equal.find(fits) ?? null;
  }

  /**
   * Takes a device into use if it was moved and there is a place for it: the place of a lost device, or else a free one.
   * The first device needs no motion if its mapping is standard.
   */
  private join(pad: Gamepad): void {
    const lost = this.seats.findIndex(({ device }) => device.state === 'lost');
    const place = lost < 0 ? this.seats.length : lost;
    if (place === MOST || !this.wasMoved(pad)) return;
    const standard = pad.mapping === 'standard';
    const rest = new Rest(standard, this.first.get(pad.index) ?? null);
    const device = new Device('pad', this.acted, rest);
    this.seats[place] = { id: pad.id, standard, index: pad.index, pad, device };
    this.first.delete(pad.index);
    this.assign();
    this.asks = this.seats.length === MOST;
  }

  /** Returns whether a device was moved since its first reading, or is the first device and needs no motion. */
  private wasMoved(pad: Gamepad): boolean {
    if (pad.mapping === 'standard' && this.seats.length === 0) return true;
    const first = this.first.get(pad.index) ?? checked(pad).reading;
    this.first.set(pad.index, first);
    // Compare with the first reading: some devices have switches that are always on, and levers that rest anywhere.
    return (
      pad.axes.some((value, i) => Math.abs(value - (first.axes[i] ?? 0)) > MOVED) ||
      pad.buttons.some(({ pressed }, i) => pressed !== first.buttons[i]?.pressed)
    );
  }

  /** Assigns each device to THC, RHC or both. A device whose assignment changes acts only after it was at zero. */
  private assign(): void {
    this.seats.forEach((seat, i) => {
      const kind = kindOf(seat.standard, this.seats.length === 1 ? null : i === 0 ? 'thc' : 'rhc');
      if (seat.device.kind === kind && seat.device.name !== '') return;
      seat.device.disarm();
      seat.device = new Device(kind, this.acted, seat.device.rest);
      seat.device.name = seat.id;
    });
  }
}

function kindOf(standard: boolean, hand: 'thc' | 'rhc' | null): Kind {
  if (hand === null) return standard ? 'pad' : 'thc joystick';
  return standard ? `${hand} pad` : `${hand} joystick`;
}

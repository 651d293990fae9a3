/** Devices of the hand controllers: keyboard, pads, SpaceMouse and touch sticks, each with its mapping. */

import type { ControllerInUse } from '../link/protocol';
import type { Action } from './action';
import { InHand, KEYS, type Names } from './active-device';
import { type Deflection, equal, type Hand, sum, ZERO } from './deflection';
import { Device } from './device';
import { Keyboard, type KeyboardListener } from './keyboard';
import type { Kind } from './mapping';
import { Pads } from './pads';
import { Pulses } from './pulses';
import { SpaceMouse } from './spacemouse';
import { mappingOf, revision } from './store';
import { TouchSticks } from './touch';

/** Greatest length of a device's name in a report [characters]. */
const LONGEST_NAME = 80;

/** Description of the devices for the desk. */
export interface ControllersShown {
  /** The devices in use, or the reason why there are none. */
  readonly words: string;
  /** Lost device of each hand controller; null if no device is lost. */
  readonly gone: Readonly<Record<Hand, string | null>>;
  /** Widest deadband among the devices of each hand controller. */
  readonly deadband: Readonly<Record<Hand, number>>;
  /** Names of keys, buttons and axes on the device in use. */
  readonly names: Names;
  /** Whether PULSE is on. */
  readonly pulsing: boolean;
}

/** Description for the desk if its page is not in control. */
export const NO_CONTROLLERS: ControllersShown = {
  words: '',
  gone: { thc: null, rhc: null },
  deadband: { thc: 0, rhc: 0 },
  names: KEYS,
  pulsing: false,
};

export class Controllers {
  readonly keyboard: Keyboard;
  readonly pads: Pads;
  readonly spaceMouse = new SpaceMouse();
  readonly touch = new TouchSticks();
  readonly pulses = new Pulses();
  /** The device in use. */
  readonly inHand: InHand;
  /** Whether the sheet of controllers is open, so that all sticks are centred. */
  paused = false;
  /** Whether a device other than the keyboard has moved since the last reading. */
  moved = false;
  private before = ZERO;
  private readonly cap: Device;
  private readonly screen: Device;

  constructor(acted: (action: Action) => void, keys: Omit<KeyboardListener, 'acted'>) {
    this.keyboard = new Keyboard({ ...keys, acted });
    this.pads = new Pads(acted);
    this.cap = new Device('spacemouse', acted);
    this.screen = new Device('touch', acted);
    this.screen.name = 'Touch sticks';
    this.inHand = new InHand(this);
  }

  /** Devices in use, without the keyboard, which always is in use. */
  get devices(): readonly Device[] {
    const others = [this.cap, this.screen].filter(({ state }) => state !== 'none');
    return [...this.pads.devices, ...others];
  }

  /** Lost devices. */
  get lost(): readonly Device[] {
    return this.devices.filter(({ state }) => state === 'lost');
  }

  /** Sentences about axes and buttons that send no numbers now, each after its device's name. */
  get faults(): readonly string[] {
    return this.devices.flatMap(({ short, faults }) => faults.map((fault) => `${short}: ${fault}`));
  }

  /** Devices that wait for an axis to be centred. */
  get waiting(): readonly Device[] {
    return this.devices.filter(({ state }) => state === 'waiting');
  }

  /**
   * Returns the deflections at `now` [ms], `dt` [s] after the last call. The call that finds a newly lost device
   * centres all devices and returns zero.
   */
  poll(now: number, dt: number): Deflection {
    const before = this.lost;
    const parts = [this.pads.poll(now), this.readCap(now), this.readScreen(now)];
    if (this.lost.some((device) => !before.includes(device))) {
      this.release();
      return ZERO;
    }
    const keys = this.keyboard.step(dt, now);
    const others = sum(...parts);
    this.moved = !equal(others, this.before);
    this.before = others;
    this.inHand.look();
    return this.pulses.take(this.paused ? ZERO : sum(keys, others), this.keyboard.pulsing);
  }

  /** Centres all devices. Then a key acts only when pressed again, and another device only after it was at zero. */
  release(): void {
    this.keyboard.release();
    this.pads.disarm();
    this.cap.disarm();
    this.touch.release();
    this.screen.disarm();
  }

  /** Acknowledges the loss of devices. */
  acknowledge(): void {
    this.pads.acknowledge();
    for (const device of [this.cap, this.screen]) if (device.state === 'lost') device.forget();
  }

  /** Present description for the desk. */
  get shown(): ControllersShown {
    return {
      words: this.words,
      gone: { thc: this.lostOf('thc'), rhc: this.lostOf('rhc') },
      deadband: { thc: this.deadband('thc'), rhc: this.deadband('rhc') },
      names: this.inHand,
      pulsing: this.pulses.active,
    };
  }

  /** A text that changes whenever the result of `inUse` changes. */
  get revision(): string {
    return `${revision()} ${this.devices.map(({ kind, name }) => `${kind} ${name}`).join()}`;
  }

  /** Devices in use and their mappings, for the recording. */
  inUse(): readonly ControllerInUse[] {
    const used = this.devices.map(({ kind, name }) => inUse(kind, name));
    return [inUse('keyboard', 'Keyboard'), ...used];
  }

  dispose(): void {
    this.keyboard.dispose();
    this.spaceMouse.dispose();
  }

  private get words(): string {
    const [lost] = this.lost;
    if (lost) return `${lost.short} lost; use the keys`;
    const [waiting] = this.waiting;
    if (waiting) return waiting.resting ? 'Off centre: see Controllers' : `Centre: ${waiting.short}`;
    const names = this.devices.map(({ short }) => short);
    return names.length === 0 ? 'Keyboard in use' : `${names.join(', ')} and keyboard in use`;
  }

  private lostOf(hand: Hand): string | null {
    return this.lost.find((device) => device.moves(hand))?.short ?? null;
  }

  private deadband(hand: Hand): number {
    return Math.max(0, ...this.devices.filter((d) => d.moves(hand)).map(({ mapping }) => mapping.deadband));
  }

  private readCap(now: number): Deflection {
    const reading = this.spaceMouse.reading(now);
    if (reading) this.cap.name = this.spaceMouse.name;
    return this.cap.read(reading, now);
  }

  private readScreen(now: number): Deflection {
    if (this.touch.shown) return this.screen.read(this.touch.reading(), now);
    this.screen.forget();
    return ZERO;
  }
}

function inUse(kind: Kind, name: string): ControllerInUse {
  const { deadband, expo, bindings, centres } = mappingOf(kind);
  return {
    kind,
    name: name.slice(0, LONGEST_NAME),
    deadband,
    expo,
    bindings: Object.entries(bindings).map(([source, use]) => `${source} ${use}`),
    centres,
  };
}

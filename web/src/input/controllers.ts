/** All that moves the hand controllers: keyboard, pads, SpaceMouse and touch sticks, each with its mapping. */

import type { ControllerInUse } from '../link/protocol';
import { InHand, KEYS, type Names } from './active-device';
import { type Deflection, equal, type Hand, sum, ZERO } from './deflection';
import { Device } from './device';
import { Keyboard, type KeyboardListener } from './keyboard';
import type { Action } from './keymap';
import type { Kind } from './mapping';
import { Pads } from './pads';
import { SpaceMouse } from './spacemouse';
import { mappingOf, revision } from './store';
import { TouchSticks } from './touch';

/** Longest name of a device that is reported [characters]. */
const LONGEST_NAME = 80;

/** What the desk shows of the devices. */
export interface ControllersShown {
  /** The device that flies, or the reason why none does. */
  readonly words: string;
  /** Of each hand controller the device that is gone; null: none. */
  readonly gone: Readonly<Record<Hand, string | null>>;
  /** Of each hand controller the widest deadband of what moves it. */
  readonly deadband: Readonly<Record<Hand, number>>;
  /** What keys, buttons and axes are called, on what is flown with at the moment. */
  readonly names: Names;
}

/** Hand controllers as the desk displays them on a page that has no control. */
export const NO_CONTROLLERS: ControllersShown = {
  words: '',
  gone: { thc: null, rhc: null },
  deadband: { thc: 0, rhc: 0 },
  names: KEYS,
};

export class Controllers {
  readonly keyboard: Keyboard;
  readonly pads: Pads;
  readonly spaceMouse = new SpaceMouse();
  readonly touch = new TouchSticks();
  /** What the operator flies with at the moment. */
  readonly inHand: InHand;
  /** They are being looked at and changed: nothing flies. */
  paused = false;
  /** A device, other than the keyboard, stood elsewhere at the last look. */
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

  /** In use, without the keyboard, which always is. */
  get devices(): readonly Device[] {
    const others = [this.cap, this.screen].filter(({ state }) => state !== 'none');
    return [...this.pads.devices, ...others];
  }

  /** The devices that were ours and are gone. */
  get lost(): readonly Device[] {
    return this.devices.filter(({ state }) => state === 'lost');
  }

  /** The devices that have not been seen at zero yet. */
  get waiting(): readonly Device[] {
    return this.devices.filter(({ state }) => state === 'waiting');
  }

  /** Return all deflections at `now` [ms], `dt` [s] after the last call; a lost device makes them zero. */
  poll(now: number, dt: number): Deflection {
    const gone = this.lost.length;
    const parts = [this.pads.poll(now), this.readCap(now), this.readScreen(now)];
    if (this.lost.length > gone) {
      this.release();
      return ZERO;
    }
    const keys = this.keyboard.step(dt);
    const others = sum(...parts);
    this.moved = !equal(others, this.before);
    this.before = others;
    this.inHand.look();
    return this.paused ? ZERO : sum(keys, others);
  }

  /** Take control away: keys must be pressed again, and devices must be at zero first. */
  release(): void {
    this.keyboard.release();
    this.pads.disarm();
    this.cap.disarm();
    this.touch.release();
    this.screen.disarm();
  }

  /** The operator knows that devices are gone. */
  acknowledge(): void {
    this.pads.acknowledge();
    for (const device of [this.cap, this.screen]) if (device.state === 'lost') device.forget();
  }

  /** What the desk shows of them now. */
  get shown(): ControllersShown {
    return {
      words: this.words,
      gone: { thc: this.lostOf('thc'), rhc: this.lostOf('rhc') },
      deadband: { thc: this.deadband('thc'), rhc: this.deadband('rhc') },
      names: this.inHand,
    };
  }

  /** Changes whenever `told` changes. */
  get revision(): string {
    return `${revision()} ${this.devices.map(({ kind, name }) => `${kind} ${name}`).join()}`;
  }

  /** What is in use and how, for the recording. */
  told(): readonly ControllerInUse[] {
    const used = this.devices.map(({ kind, name }) => inUse(kind, name));
    return [inUse('keyboard', 'Keyboard'), ...used];
  }

  dispose(): void {
    this.keyboard.dispose();
    this.spaceMouse.dispose();
  }

  private get words(): string {
    const [lost] = this.lost;
    if (lost) return `${lost.short} is gone; keys fly`;
    const [waiting] = this.waiting;
    if (waiting) return waiting.resting ? 'Off centre: see Controllers' : `Let go: ${waiting.short}`;
    const names = this.devices.map(({ short }) => short);
    return names.length === 0 ? 'Keyboard flies' : `${names.join(', ')} and keyboard fly`;
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

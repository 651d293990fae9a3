/** One device with axes and buttons: from its raw reading to axes and actions, and whether it may fly. */

import { clamp } from '../basics/clamp';
import { AXES, type Deflection, HANDS, type Hand, isZero, ZERO } from './deflection';
import { type Action, type Grip, USES } from './keymap';
import { centred, indexOf, type Kind, type Mapping, shape } from './mapping';
import { mappingOf } from './store';

/** What a device shows at a moment. */
export interface Reading {
  /** Each in [-1, 1]. */
  readonly axes: readonly number[];
  readonly buttons: readonly { readonly pressed: boolean; readonly value: number }[];
}

/** `none`: never seen · `waiting`: not yet seen at zero · `flying` · `lost`: gone while it was ours. */
export type DeviceState = 'none' | 'waiting' | 'flying' | 'lost';

/** Time without motion after which an axis off zero counts as at rest [ms]. */
const REST_MS = 1500;
/** A sensor's noise. */
const STILL = 0.02;

/** How far a button is pressed; some drivers tell only that it is. */
function travel(reading: Reading, index: number): number {
  const button = reading.buttons[index];
  return button ? button.value || Number(button.pressed) : 0;
}

/** What a source gives before deadband and expo; a button that another one changes the use of gives nothing. */
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

/** The axes that a reading deflects, before (`shaped` false) or after deadband and expo. */
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
  /** As the browser names it; empty before it was first seen. */
  name = '';
  /** What it shows now; null: it is not there. */
  reading: Reading | null = null;
  /** Off zero without motion: a sensor with an offset, not a deflection. */
  resting = false;
  /** Buttons down, each with the use that it went down for. */
  private readonly down = new Map<number, string | undefined>();
  /** A button that changes others' uses is down, and nothing was pressed with it. */
  private alone: number | null = null;
  private still: { axes: readonly number[]; since: number } = { axes: [], since: 0 };

  constructor(
    readonly kind: Kind,
    private readonly acted: (action: Action) => void,
  ) {}

  get mapping(): Mapping {
    return mappingOf(this.kind);
  }

  /** The browser's name without what it says in brackets. */
  get short(): string {
    return this.name.replace(/\s*\(.*$/, '').slice(0, 26) || this.kind;
  }

  /** Whether it moves this hand controller. */
  moves(hand: Hand): boolean {
    const axes = HANDS[hand].map((axis) => AXES[axis]);
    return Object.values(this.mapping.bindings).some((use) => axes.some((axis) => axis === use.slice(1)));
  }

  /** Takes what it shows at `now` [ms]; anything but a flying device is at zero. */
  read(reading: Reading | null, now: number): Deflection {
    this.reading = reading;
    if (!reading) {
      if (this.state !== 'none') this.state = 'lost';
      this.resting = false;
      this.letGo();
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

  /** Take control away until the device has been at zero; a held button must be pressed again. */
  disarm(): void {
    if (this.state === 'flying') this.wait();
    for (const [index, use] of this.down) {
      this.down.set(index, undefined);
      this.end(use);
    }
    this.alone = null;
  }

  /** The operator put it away; its absence is not reported. */
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
        this.alone = changers.has(index) ? index : null;
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

  /** It is gone: nothing is held any more. */
  private letGo(): void {
    const uses = [...this.down.values()];
    this.down.clear();
    this.alone = null;
    for (const use of uses) this.end(use);
  }
}

/** The sheet “Controllers”: live axes and assignments of each device. It changes assignments and centres the sticks. */

import type { Controllers } from '../../input/controllers';
import type { Device } from '../../input/device';
import { type Kind, MOST_DEADBAND } from '../../input/mapping';
import { zeroWords } from '../../input/rebind';
import { isDefault, mappingOf, restore, revision, save } from '../../input/store';
import { button, el, setText } from '../parts/dom';
import { range } from '../parts/range';
import { Assignment } from './assignment';
import { AxisTable } from './axis-table';
import { Choices } from './choices';
import { UseTable } from './use-table';

export class ControllersSheet {
  readonly element: HTMLDialogElement;
  private kind: Kind = 'keyboard';
  private drawn = '';
  private readonly choices;
  private readonly axes = new AxisTable((use) => this.ask(use));
  private readonly uses = new UseTable((use) => this.ask(use));
  private readonly assignment = new Assignment((use) => {
    this.axes.ask(use);
    this.uses.ask(use);
  });
  private readonly state = el('span', { class: 'state' });
  private readonly deadband = range('Deadband', MOST_DEADBAND, 0.01, percent, (deadband) =>
    this.change({ deadband }),
  );
  private readonly expo = range(
    'Expo',
    1,
    0.05,
    (value) => value.toFixed(2),
    (expo) => this.change({ expo }),
  );
  private readonly zero = button(
    { title: 'Set the present positions of the axes as zero' },
    ['Set zero'],
    () => this.zeroNow(),
  );
  private readonly swap = button({}, ['Swap THC, RHC'], () => this.controllers.pads.swap());
  private readonly connect = button({}, ['Connect'], () => void this.controllers.spaceMouse.connect());
  private readonly show = button({}, ['Show them'], () => this.controllers.touch.show());
  private readonly restore = button({}, ['Defaults'], () => this.toDefault());

  constructor(private readonly controllers: Controllers) {
    this.choices = new Choices((kind) => this.choose(kind));
    this.element = el(
      'dialog',
      { class: 'controllers', 'aria-label': 'Controllers', tabindex: '-1' },
      el(
        'header',
        {},
        el('h2', {}, 'Controllers'),
        this.choices.element,
        button({ class: 'done' }, ['Close'], () => this.close()),
      ),
      el(
        'div',
        { class: 'setting' },
        this.state,
        this.deadband.element,
        this.expo.element,
        this.connect,
        this.show,
        this.swap,
        this.zero,
        this.restore,
      ),
      this.assignment.element,
      el('div', { class: 'tables' }, this.axes.element, this.uses.element),
    );
    this.element.addEventListener('close', () => this.left());
  }

  open(): void {
    if (this.element.open) return;
    this.controllers.release();
    this.controllers.paused = true;
    const [first] = this.controllers.devices;
    this.choose(first?.kind ?? 'keyboard');
    this.element.showModal();
    this.element.focus();
  }

  close(): void {
    this.element.close();
    this.left();
  }

  /** Assigns a pressed key if the sheet waits for a key; returns whether it has used the key. */
  taken(event: KeyboardEvent): boolean {
    return this.element.open && this.assignment.taken(event);
  }

  /** Displays all present values. */
  tick(): void {
    if (!this.element.open) return;
    const device = this.device;
    this.assignment.look(device?.reading ?? null);
    this.choices.show(this.controllers, this.kind);
    const signature = `${this.kind} ${revision()}`;
    if (signature !== this.drawn) this.fill(signature);
    this.settings(device);
    const keys = this.controllers.keyboard;
    if (this.kind === 'keyboard') this.axes.keys(keys.target, keys.value, keys.held);
    else this.axes.device(device, mappingOf(this.kind));
    this.uses.light(this.kind === 'keyboard' ? keys.held : pressed(device));
  }

  private get device(): Device | null {
    return this.controllers.devices.find(({ kind }) => kind === this.kind) ?? null;
  }

  private choose(kind: Kind): void {
    this.kind = kind;
    this.drawn = '';
    this.assignment.end();
    this.tick();
  }

  private fill(signature: string): void {
    this.drawn = signature;
    const focused = document.activeElement?.getAttribute('data-use');
    this.axes.fill(this.kind);
    this.uses.fill(this.kind);
    if (focused) this.element.querySelector<HTMLElement>(`[data-use="${CSS.escape(focused)}"]`)?.focus();
  }

  private settings(device: Device | null): void {
    const mapping = mappingOf(this.kind);
    const keyboard = this.kind === 'keyboard';
    setText(this.state, stateWords(this.kind, device, this.controllers));
    this.deadband.show(mapping.deadband, !keyboard);
    this.expo.show(mapping.expo, !keyboard);
    const { spaceMouse, pads, touch } = this.controllers;
    this.connect.hidden = this.kind !== 'spacemouse' || !spaceMouse.possible || Boolean(device?.reading);
    this.show.hidden = this.kind !== 'touch' || touch.shown;
    this.swap.hidden = pads.devices.length < 2 || !/pad|joystick/.test(this.kind);
    this.zero.hidden = keyboard || this.kind === 'touch' || !device?.reading;
    this.restore.hidden = isDefault(this.kind);
  }

  private ask(use: string): void {
    this.controllers.keyboard.release();
    this.assignment.ask(this.kind, use, this.device?.reading ?? null);
  }

  private change(part: { readonly deadband?: number; readonly expo?: number }): void {
    save(this.kind, { ...mappingOf(this.kind), ...part });
  }

  private toDefault(): void {
    restore(this.kind);
    this.assignment.end('All assignments are the defaults.');
  }

  private zeroNow(): void {
    const { device } = this;
    if (device?.reading) this.assignment.end(zeroWords(device.kind, device.setZero()));
  }

  private left(): void {
    if (!this.controllers.paused) return;
    this.assignment.end();
    this.controllers.release();
    this.controllers.paused = false;
  }
}

function percent(value: number): string {
  return `${Math.round(100 * value)} %`;
}

/** Returns the sources of the pressed buttons. */
function pressed(device: Device | null): ReadonlySet<string> {
  const buttons = device?.reading?.buttons ?? [];
  return new Set(buttons.flatMap((each, i) => (each.pressed || each.value > 0.5 ? [`b${i}`] : [])));
}

const STATES = {
  none: '',
  waiting: 'centre all its sticks',
  flying: 'ready',
  lost: 'lost',
} as const;

function stateWords(kind: Kind, device: Device | null, { spaceMouse }: Controllers): string {
  if (kind === 'keyboard') return 'Keyboard: keys by their position.';
  if (kind === 'spacemouse' && !spaceMouse.possible)
    return 'This browser has no WebHID, which a SpaceMouse needs; Chrome and Edge have it.';
  if (kind === 'spacemouse' && spaceMouse.problem) return spaceMouse.problem;
  if (device) {
    const state = device.resting
      ? 'off centre; release it and set zero, or remove its assignment'
      : STATES[device.state];
    return [`${device.short}: ${state}`, ...device.faults].join('. ');
  }
  if (kind === 'touch') return 'Touch sticks appear when the screen is touched.';
  if (kind === 'spacemouse') return 'No SpaceMouse is connected.';
  return 'No pad is connected: press one of its buttons.';
}

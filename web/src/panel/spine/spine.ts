/** The lamps between the monitors, below the master alarm. Lamps show their cause. */

import { KEYS, type Names } from '../../input/active-device';
import type { Alarm } from '../../page/tones';
import { button, el, setAttribute, setClass, setText } from '../parts/dom';
import { type LampName, lampsIn, type Row, type SpineLamp } from './lamps';

/** Time for which the calm page keeps the spine after its last lamp [ms]. */
export const KEPT_MS = 20_000;
/** Order of the levels. An acknowledged lamp sounds again when its level rises. */
const RANK = { info: 0, caution: 1, warning: 2 } as const;

export interface SpineListener {
  acknowledged(): void;
  /** A lamp was pressed; `lamp` is its name. */
  pressed(lamp: LampName): void;
}

export class Spine {
  readonly element: HTMLElement;
  private readonly lamps = new Map<LampName, { key: HTMLButtonElement; cause: HTMLElement }>();
  private readonly words = el('span');
  private readonly master: HTMLButtonElement;
  private readonly polite = el('p', { class: 'unseen', 'aria-live': 'polite' });
  private readonly alert = el('p', { class: 'unseen', role: 'alert' });
  private lit = new Map<LampName, SpineLamp>();
  private unseen = new Set<LampName>();
  private names: Names = KEYS;
  private raised = false;
  /** When a lamp was lit last [ms]. */
  private litAt = Number.NEGATIVE_INFINITY;
  private readonly silent = el('p', { class: 'silent' }, 'Tones muted');

  constructor(private readonly listener: SpineListener) {
    this.master = button({ class: 'master' }, [el('b', {}, 'Master alarm'), this.words], () =>
      listener.acknowledged(),
    );
    this.element = el(
      'section',
      { class: 'spine', 'aria-label': 'Lamps' },
      this.master,
      this.silent,
      this.row('arm'),
      this.row('pair', 'lamp-pairs'),
      this.row('station'),
      this.polite,
      this.alert,
    );
    this.show([]);
  }

  /**
   * Lights exactly these lamps. `test`: also lights all other lamps, but raises no alarm for them. `names`: those of the
   * device in use.
   */
  show(lamps: readonly SpineLamp[], test = false, names = this.names): void {
    this.names = names;
    const now = new Map(lamps.map((lamp) => [lamp.name, lamp]));
    for (const [name, lamp] of now) {
      const rises = RANK[lamp.level] > RANK[this.lit.get(name)?.level ?? 'info'];
      if (rises && !lamp.standing) this.raise(lamp);
    }
    this.lit = now;
    for (const name of this.unseen)
      if (!now.has(name) || now.get(name)?.level === 'info') this.unseen.delete(name);
    for (const [name, { key, cause }] of this.lamps) {
      const lamp = now.get(name);
      setClass(key, 'caution', lamp?.level === 'caution' || (test && lamp?.level !== 'warning'));
      setClass(key, 'warning', lamp?.level === 'warning');
      setClass(key, 'info', lamp?.level === 'info' && !test);
      setText(cause, lamp?.text ?? '');
      setAttribute(key, 'title', lamp?.text ?? '');
    }
    const warned = lamps.some(({ level, name }) => level === 'warning' && this.unseen.has(name));
    setClass(this.master, 'caution', (test || this.unseen.size > 0) && !warned);
    setClass(this.master, 'warning', warned);
    const count = counted(lamps);
    this.keep(test || lamps.some(({ level }) => level !== 'info'));
    if (test) setText(this.words, 'lamp test');
    else
      setText(
        this.words,
        count === ''
          ? 'clear'
          : this.unseen.size > 0
            ? `${count} · press ${names.name('acknowledge')}`
            : count,
      );
  }

  /** Returns the highest level of the unacknowledged lamps, and whether a new alarm occurred since the last call. */
  takeAlarm(): { readonly alarm: Alarm; readonly more: boolean } {
    const levels = [...this.unseen].map((name) => this.lit.get(name)?.level);
    const alarm = levels.includes('warning') ? 'warning' : levels.length > 0 ? 'caution' : 'none';
    const more = this.raised;
    this.raised = false;
    return { alarm, more };
  }

  /** Shows beside the master alarm whether the tones are muted. */
  setMuted(muted: boolean): void {
    this.silent.hidden = !muted;
  }

  /** Acknowledges all lamps that are lit. */
  acknowledge(): void {
    this.unseen.clear();
    this.show([...this.lit.values()]);
  }

  /** Keeps the spine in the calm page for a while after its last lamp, so that the pictures keep their sizes. */
  private keep(lit: boolean): void {
    const now = performance.now();
    if (lit) this.litAt = now;
    setClass(this.element, 'lit-lately', now - this.litAt < KEPT_MS);
  }

  /** Called at a restart: the calm page no longer keeps the spine for lamps of before. */
  forget(): void {
    this.litAt = Number.NEGATIVE_INFINITY;
  }

  private raise(lamp: SpineLamp): void {
    this.raised = true;
    this.unseen.add(lamp.name);
    setText(lamp.level === 'warning' ? this.alert : this.polite, `${lamp.name}: ${lamp.text}`);
  }

  private row(row: Row, name = 'lamps'): HTMLElement {
    return el('div', { class: name }, ...lampsIn(row).map((lamp) => this.lamp(lamp)));
  }

  private lamp(name: LampName): HTMLButtonElement {
    const cause = el('small');
    const key = button({ class: 'lamp' }, [el('b', {}, name), cause], () => this.listener.pressed(name));
    this.lamps.set(name, { key, cause });
    return key;
  }
}

/** Returns the number of lamps, such as `1 warning, 2 cautions`; empty if none is lit. */
export function counted(lamps: readonly Pick<SpineLamp, 'level'>[]): string {
  return (['warning', 'caution'] as const)
    .map((name) => ({ name, count: lamps.filter(({ level }) => level === name).length }))
    .filter(({ count }) => count > 0)
    .map(({ name, count }) => `${count} ${name}${count === 1 ? '' : 's'}`)
    .join(', ');
}

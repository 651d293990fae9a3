/** The key map: shows the present mappings over the monitors. A key cap lights while its key is pressed. */

import { keyOf, learnLayout, nameOfSource } from '../../input/layout';
import { type Kind, sourcesOf } from '../../input/mapping';
import { mappingOf } from '../../input/store';
import { FLYING } from '../../input/uses/flying';
import { LEFT_HAND, RIGHT_HAND } from '../../input/uses/sticks';
import { type Row, rowsFor } from '../../input/uses/use';
import { WORKING } from '../../input/uses/working';
import type { Welcome } from '../../link/protocol';
import { button, el, setClass } from '../parts/dom';

export class KeyMap {
  readonly element = el('dialog', {
    class: 'key-map',
    'aria-label': 'Key map',
    tabindex: '-1',
    autofocus: '',
  });
  private caps = new Map<string, HTMLElement[]>();

  /** `change` opens the sheet “Controllers”, which changes the assignments. */
  constructor(
    private readonly welcome: Welcome,
    private readonly change: () => void,
  ) {
    void learnLayout().then(() => this.fill());
  }

  toggle(): void {
    if (this.element.open) this.close();
    else {
      this.fill();
      this.element.show();
      this.element.focus();
    }
  }

  close(): void {
    this.element.close();
  }

  /** Lights the caps of the pressed keys. */
  light(held: ReadonlySet<string>): void {
    if (!this.element.open) return;
    for (const [code, caps] of this.caps) {
      for (const cap of caps) setClass(cap, 'held', held.has(code));
    }
  }

  /** Fills the sheet according to the present mappings. */
  private fill(): void {
    this.caps = new Map();
    this.element.replaceChildren(
      el('h2', { class: 'unseen' }, 'Key map'),
      el(
        'div',
        { class: 'hands' },
        this.hand('Left hand moves', LEFT_HAND),
        this.hand('Right hand turns', RIGHT_HAND),
      ),
      el('div', {}, el('h3', {}, 'Arm and cameras'), this.table(FLYING)),
      el(
        'div',
        { class: 'working' },
        el('h3', {}, 'End effector, worksite, panel'),
        this.table(WORKING),
        el('p', {}, 'MASTER: arrow keys move the focused slider by 0.5°, Page up and Page down by 5°.'),
        el(
          'p',
          {},
          'Keys are assigned by position. In a text field, keys write text and do not move the arm.',
        ),
        el(
          'div',
          { class: 'close' },
          button({}, ['Change controllers'], () => this.change()),
          button({}, ['Close'], () => this.close()),
        ),
      ),
    );
  }

  private hand(title: string, rows: readonly Row[]): HTMLElement {
    const uses = rows.flatMap(capsOf);
    const caps = rowsFor(this.welcome, rows).flatMap(([row, help]) =>
      capsOf(row).map((use) => this.cap(use, help)),
    );
    const pad = [...new Set(uses.flatMap((use) => sources('pad', use)))];
    return el(
      'div',
      {},
      el('h3', {}, title),
      el('div', { class: 'caps' }, ...caps),
      el('p', {}, `Pad: ${together(pad)}`),
    );
  }

  private table(rows: readonly Row[]): HTMLElement {
    const lines = rowsFor(this.welcome, rows).map(([row, help]) => {
      // The buttons of a row without functions of its own are in other rows.
      const pad = row.uses.length > 0 ? together(capsOf(row).flatMap((use) => sources('pad', use))) : '';
      return el(
        'tr',
        {},
        el('th', { scope: 'row' }, ...this.keysOf(row)),
        el('td', {}, help),
        el('td', { class: 'pad' }, pad && `pad ${pad}`),
      );
    });
    return el('table', {}, ...lines);
  }

  private keysOf(row: Row): (Node | string)[] {
    const caps = capsOf(row).map((use) => this.cap(use));
    return row.range ? [...caps.slice(0, 1), ' … ', ...caps.slice(-1)] : caps;
  }

  private cap(use: string, help = ''): HTMLElement {
    const cap = el('kbd', {}, el('b', {}, keyOf(use) || '–'), ...(help ? [el('small', {}, help)] : []));
    for (const code of sourcesOf(mappingOf('keyboard'), use)) {
      this.caps.set(code, [...(this.caps.get(code) ?? []), cap]);
    }
    return cap;
  }
}

/** Returns the functions whose keys a row shows. */
function capsOf({ caps, uses }: Row): readonly string[] {
  return caps ?? uses.map(({ name }) => name);
}

function sources(kind: Kind, use: string): readonly string[] {
  return sourcesOf(mappingOf(kind), use).map((source) => nameOfSource(kind, source));
}

/** Joins names. Words with which all names begin are written once: `Menu + Cross ↓ ↑`. */
export function together(names: readonly string[]): string {
  const [first = '', ...others] = names;
  if (others.length === 0) return first;
  let alike = first.lastIndexOf(' ') + 1;
  while (alike > 0 && !others.every((name) => name.startsWith(first.slice(0, alike))))
    alike = first.lastIndexOf(' ', alike - 2) + 1;
  return alike > 0 ? [first, ...others.map((name) => name.slice(alike))].join(' ') : names.join(', ');
}

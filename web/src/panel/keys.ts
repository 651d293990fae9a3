/** The key map, over the monitors; its caps light as they are pressed. */

import { learnLayout, nameOf } from '../input/layout';
import { button, el, setClass } from './dom';

const LEFT = [
  ['KeyQ', 'up'],
  ['KeyW', '+X'],
  ['KeyE', 'down'],
  ['KeyA', 'left'],
  ['KeyS', '−X'],
  ['KeyD', 'right'],
] as const;

const RIGHT = [
  ['KeyU', 'roll −'],
  ['KeyI', 'nose up'],
  ['KeyO', 'roll +'],
  ['KeyJ', 'left'],
  ['KeyK', 'nose dn'],
  ['KeyL', 'right'],
] as const;

type Row = readonly [codes: readonly string[], does: string, pad: string];

/** Keys by place, what they do, and the pad's way. */
const FLYING: readonly Row[] = [
  [['Space'], 'stop: sticks to zero, a sequence to rest', 'east'],
  [['KeyV'], 'coarse or vernier', 'south'],
  [['KeyH'], 'rate hold: keep the present rates, let go of them', 'west'],
  [['BracketLeft', 'BracketRight', 'Enter'], 'turn the mode rotary, enter the mode', ''],
  [['Minus', 'Equal'], 'joint in SINGLE and DIRECT; then W and S drive it', ''],
  [['KeyP'], 'proceed: to the target, or on from a pause point', ''],
  [['KeyM'], 'acknowledge the master alarm', ''],
  [['KeyX'], 'the other monitor, or half, in hand', 'view'],
  [['Digit1', 'Digit0'], 'camera 1 to 10 in hand; twice: 11 to 20', ''],
  [['Comma', 'Period'], 'camera before, after', 'menu'],
  [['ArrowLeft', 'ArrowUp', 'PageUp'], 'and their opposites: pan, tilt, zoom', ''],
  [['Semicolon'], 'cameras turn slowly', ''],
  [['KeyC', 'KeyZ'], 'all cameras, and back; split', ''],
];

const WORKING: readonly Row[] = [
  [['KeyG'], 'held 0.3 s: capture; the prong closes', 'north'],
  [['KeyR'], 'held 1 s: release; the prong opens', 'menu + north'],
  [['KeyG', 'KeyR'], 'while the prong moves: either stops it', ''],
  [['KeyT'], 'held 1 s: latch the payload in its seat, or unlatch', 'menu + south'],
  [['KeyF'], 'separating plane in the pictures', 'menu + west'],
  [['KeyY', 'KeyN'], 'telescope longer, shorter', 'menu + cross'],
  [['Backquote'], 'THC flies the orbiter, or the arm again', 'menu + view'],
];

export class KeyMap {
  readonly element: HTMLDialogElement;
  private readonly caps = new Map<string, HTMLElement[]>();

  constructor() {
    this.element = el(
      'dialog',
      { class: 'key-map', 'aria-label': 'Key map', tabindex: '-1', autofocus: '' },
      el(
        'div',
        { class: 'hands' },
        this.hand('Left hand moves', LEFT, 'Pad: left stick; triggers up, down'),
        this.hand('Right hand turns', RIGHT, 'Pad: right stick; bumpers roll'),
      ),
      el('div', {}, el('h3', {}, 'Arm and cameras'), this.table(FLYING)),
      el(
        'div',
        { class: 'working' },
        el('h3', {}, 'End effector and worksite'),
        this.table(WORKING),
        el('p', {}, 'MASTER: arrows move the slider in focus by half a degree, Page up, down by five.'),
        el('p', {}, 'Keys go by their place. In a text field, keys type and do not fly.'),
        button({ class: 'close' }, ['Close'], () => this.close()),
      ),
    );
    void learnLayout().then(() => this.letter());
  }

  toggle(): void {
    if (this.element.open) this.close();
    else this.element.show();
  }

  close(): void {
    this.element.close();
  }

  /** Lights the caps of the keys held. */
  light(held: ReadonlySet<string>): void {
    if (!this.element.open) return;
    for (const [code, caps] of this.caps) {
      for (const cap of caps) setClass(cap, 'held', held.has(code));
    }
  }

  private hand(title: string, keys: readonly (readonly [string, string])[], pad: string): HTMLElement {
    const caps = keys.map(([code, does]) => {
      const cap = this.cap(code);
      cap.append(el('small', {}, does));
      return cap;
    });
    return el('div', {}, el('h3', {}, title), el('div', { class: 'caps' }, ...caps), el('p', {}, pad));
  }

  private table(rows: readonly Row[]): HTMLElement {
    const lines = rows.map(([codes, does, pad]) =>
      el(
        'tr',
        {},
        el('th', { scope: 'row' }, ...this.row(codes)),
        el('td', {}, does),
        el('td', { class: 'pad' }, pad && `pad ${pad}`),
      ),
    );
    return el('table', {}, ...lines);
  }

  private row(codes: readonly string[]): (Node | string)[] {
    const caps = codes.map((code) => this.cap(code));
    return codes[0] === 'Digit1' ? [caps[0] ?? '', ' … ', caps[1] ?? ''] : caps;
  }

  private cap(code: string): HTMLElement {
    const cap = el('kbd', {}, el('b', {}, nameOf(code)));
    this.caps.set(code, [...(this.caps.get(code) ?? []), cap]);
    return cap;
  }

  /** Shows the letters of the user's layout. */
  private letter(): void {
    for (const [code, caps] of this.caps) {
      for (const cap of caps) cap.querySelector('b')?.replaceChildren(nameOf(code));
    }
  }
}

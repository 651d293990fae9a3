/** The key map, over the monitors; its caps light as they are pressed. */

import { AXIS_KEYS } from '../input/keymap';
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

/** Keys by place (empty: named by the text after), what they do, and the pad's way. */
const REST: readonly (readonly [readonly string[], string, string])[] = [
  [['Space'], 'stop: sticks to zero, a sequence to rest', 'east'],
  [['KeyV'], 'coarse or vernier', 'south'],
  [['KeyH'], 'rate hold: keep the present rates, let go of them', 'west'],
  [['BracketLeft', 'BracketRight', 'Enter'], 'turn the mode rotary, enter the mode', ''],
  [['Minus', 'Equal'], 'joint in SINGLE and DIRECT; then W and S drive it', ''],
  [['KeyP'], 'proceed: to the target, or on from a pause point', ''],
  [['Digit1', 'Digit9'], 'camera 1 to 9 on the monitor in hand', ''],
  [['Comma', 'Period'], 'camera before, after', 'menu'],
  [['KeyX'], 'the other monitor in hand', 'view'],
  [['KeyM'], 'acknowledge the master alarm', ''],
];

const NAMES: Readonly<Record<string, string>> = {
  Space: 'Space',
  Enter: 'Enter',
  Minus: '−',
  Equal: '=',
  BracketLeft: '[',
  BracketRight: ']',
  Comma: ',',
  Period: '.',
};

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
      el(
        'table',
        {},
        ...REST.map(([codes, does, pad]) =>
          el(
            'tr',
            {},
            el('th', { scope: 'row' }, ...this.row(codes)),
            el('td', {}, does),
            el('td', { class: 'pad' }, pad && `pad ${pad}`),
          ),
        ),
      ),
      el('p', {}, 'Keys go by their place. In a text field, keys type and do not fly.'),
      button({ class: 'close' }, ['Close'], () => this.close()),
    );
    void this.useLayout();
  }

  toggle(): void {
    if (this.element.open) this.close();
    else this.element.show();
  }

  close(): void {
    this.element.close();
  }

  /** Lights the caps of the flying keys held. */
  light(held: ReadonlySet<string>): void {
    if (!this.element.open) return;
    for (const code of AXIS_KEYS.keys()) {
      for (const cap of this.caps.get(code) ?? []) setClass(cap, 'held', held.has(code));
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

  private row(codes: readonly string[]): (Node | string)[] {
    const caps = codes.map((code) => this.cap(code));
    return codes[0] === 'Digit1' ? [caps[0] ?? '', ' … ', caps[1] ?? ''] : caps;
  }

  private cap(code: string): HTMLElement {
    const cap = el('kbd', {}, el('b', {}, NAMES[code] ?? code.replace(/^(Key|Digit)/, '')));
    this.caps.set(code, [...(this.caps.get(code) ?? []), cap]);
    return cap;
  }

  /** Shows the letters of the user's layout where the browser tells them. */
  private async useLayout(): Promise<void> {
    const { keyboard } = navigator as Navigator & {
      keyboard?: { getLayoutMap(): Promise<ReadonlyMap<string, string>> };
    };
    const layout = await keyboard?.getLayoutMap().catch(() => undefined);
    for (const [code, caps] of this.caps) {
      const letter = layout?.get(code)?.toUpperCase();
      if (!letter || code in NAMES) continue;
      for (const cap of caps) cap.querySelector('b')?.replaceChildren(letter);
    }
  }
}

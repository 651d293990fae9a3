/** The key map: shows the present mappings over the monitors. A key cap lights while its key is pressed. */

import { keyOf, learnLayout, nameOfSource } from '../../input/layout';
import { type Kind, sourcesOf } from '../../input/mapping';
import { mappingOf } from '../../input/store';
import type { Welcome } from '../../link/protocol';
import { button, el, setClass } from '../parts/dom';

type Cap = readonly [use: string, does: string];

const LEFT: readonly Cap[] = [
  ['-Z', '−Z up'],
  ['+X', '+X fwd'],
  ['+Z', '+Z down'],
  ['-Y', '−Y left'],
  ['-X', '−X aft'],
  ['+Y', '+Y right'],
];

const RIGHT: readonly Cap[] = [
  ['-roll', '−roll'],
  ['+pitch', '+pitch up'],
  ['+roll', '+roll'],
  ['-yaw', '−yaw left'],
  ['-pitch', '−pitch dn'],
  ['+yaw', '+yaw right'],
];

type Row = readonly [uses: readonly string[], does: string, pad?: 'no pad'];

/** Rows for the arm and the cameras: functions, and their effects. */
const FLYING: readonly Row[] = [
  [['stop'], 'stop: centre the sticks, stop a sequence'],
  [['brakes'], 'brakes on; held 0.5 s: off'],
  [['rate', 'rate hold'], 'coarse or vernier; rate hold, or cancel'],
  [['pulse'], 'held, or a button: each push moves 0.1 in, 0.1°'],
  [['mode -', 'mode +', 'enter'], 'turn the mode rotary, enter the mode'],
  [['joint -', 'joint +'], 'joint in SINGLE, DIRECT; THC X drives it'],
  [['proceed'], 'proceed: start, or continue after a pause'],
  [['otherMonitor'], 'select the other monitor, or half'],
  [['camera 1', 'camera 10'], 'camera 1 to 10; twice: camera 11 to 20'],
  [['cameraStep -', 'cameraStep +', 'offered pair'], 'previous, next camera; offered pair'],
  [['-pan', '+tilt', '+zoom'], 'and opposites: pan, tilt, zoom'],
  [['slow camera'], 'cameras turn slowly'],
  [['matrix', 'split'], 'all cameras, and back; split'],
  [['light', 'lock exposure'], 'sun and lamps; lock the exposure'],
];

/** Returns the rows for this arm's end effector, the worksite and the panel: functions, and their effects. */
export function working({
  work: { hand, stand },
  flexures,
}: Pick<Welcome, 'flexures' | 'work'>): readonly Row[] {
  const prong: readonly Row[] = [
    [['close'], 'held 0.3 s: the prong closes'],
    [['open'], 'held 1 s: the prong opens'],
    [['close', 'open'], 'while the prong moves: either stops it', 'no pad'],
  ];
  const snares: readonly Row[] = [
    [['close'], 'held 0.3 s: capture'],
    [['open'], 'held 1 s: release'],
  ];
  return [
    ...(hand === 'prong' ? prong : snares),
    [['latch'], 'held 1 s: latch the payload in its berth, or unlatch'],
    [['safing', 'position hold'], 'safing, position hold; again: off'],
    [['plane'], 'separating plane in the pictures'],
    ...(flexures.length > 0 ? ([[['bending'], 'bending exaggerated in the pictures']] as const) : []),
    [['acknowledge', 'mute'], 'acknowledge the master alarm; sounds off, on'],
    [['announce'], 'announce a clearance problem: it is logged'],
    [['control page'], 'PDRS control: target, stored points, payloads'],
    ...(stand ? ([[['-telescope', '+telescope'], 'telescope shorter, longer']] as const) : []),
    [['fly orbiter'], 'assign the THC to the orbiter, or to the arm'],
  ];
}

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
      el('div', { class: 'hands' }, this.hand('Left hand moves', LEFT), this.hand('Right hand turns', RIGHT)),
      el('div', {}, el('h3', {}, 'Arm and cameras'), this.table(FLYING)),
      el(
        'div',
        { class: 'working' },
        el('h3', {}, 'End effector, worksite, panel'),
        this.table(working(this.welcome)),
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

  private hand(title: string, keys: readonly Cap[]): HTMLElement {
    const caps = keys.map(([use, does]) => {
      const cap = this.cap(use);
      cap.append(el('small', {}, does));
      return cap;
    });
    const pad = [...new Set(keys.flatMap(([use]) => sources('pad', use)))];
    return el(
      'div',
      {},
      el('h3', {}, title),
      el('div', { class: 'caps' }, ...caps),
      el('p', {}, `Pad: ${together(pad)}`),
    );
  }

  private table(rows: readonly Row[]): HTMLElement {
    const lines = rows.map(([uses, does, noPad]) => {
      const pad = noPad ? '' : together(uses.flatMap((use) => sources('pad', use)));
      return el(
        'tr',
        {},
        el('th', { scope: 'row' }, ...this.row(uses)),
        el('td', {}, does),
        el('td', { class: 'pad' }, pad && `pad ${pad}`),
      );
    });
    return el('table', {}, ...lines);
  }

  private row(uses: readonly string[]): (Node | string)[] {
    const caps = uses.map((use) => this.cap(use));
    return uses[0] === 'camera 1' ? [caps[0] ?? '', ' … ', caps[1] ?? ''] : caps;
  }

  private cap(use: string): HTMLElement {
    const cap = el('kbd', {}, el('b', {}, keyOf(use) || '–'));
    for (const code of sourcesOf(mappingOf('keyboard'), use)) {
      this.caps.set(code, [...(this.caps.get(code) ?? []), cap]);
    }
    return cap;
  }
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

/**
 * Texts of a step, with marks: `{+X}` stands for a key or a stick, `{0.05 m}` for a length, `{wanting}` for the first
 * condition that fails, `{keys|sticks}` for words that fit the device in use; `*RIGID*` quotes a text on the desk.
 */

import type { InHand } from '../input/active-device';
import { revision } from '../input/store';
import type { Condition, HintInfo, StepInfo, TaskNow } from '../link/protocol';
import { el } from '../panel/parts/dom';
import { failureText } from '../words/condition-text';
import { lengthText } from '../words/format';
import type { Units } from '../words/units';

export interface Piece {
  /** `either`: words for the keyboard and for a device with sticks, `keys|sticks`. */
  readonly kind: 'text' | 'use' | 'shown' | 'either';
  readonly text: string;
}

/** Data from which the marks of a text are replaced. */
export interface Marked {
  readonly units: Units;
  readonly conditions: readonly Condition[];
  /** Whether the end effector holds a payload. */
  readonly held?: boolean;
}

/** Text in place of a failing condition if there is none: with an empty end effector, and with a payload. */
const NOTHING_NEAR = 'nothing to capture is near';
const NO_BERTH_NEAR = 'the payload is still too far away';
/** Names of keys that a screen reader would skip, because they are marks of punctuation. */
const SPOKEN: Readonly<Record<string, string>> = {
  '.': 'full stop',
  ',': 'comma',
  ';': 'semicolon',
  '’': 'apostrophe',
  '`': 'grave accent',
  '−': 'minus',
  '=': 'equals',
  '[': 'left bracket',
  ']': 'right bracket',
  '/': 'slash',
  '\\': 'backslash',
};
const LENGTH = /^([\d.e+-]+) m$/;

/** Splits a text into pieces; lengths and the failing condition become plain text, functions keep their names. */
export function pieces(words: string, { units, conditions, held }: Marked): readonly Piece[] {
  return words
    .split(/(\{[^}]+\}|\*[^*]+\*)/)
    .filter((part) => part !== '')
    .map((part) => {
      const inside = part.slice(1, -1);
      if (part.startsWith('*')) return { kind: 'shown', text: inside };
      if (!part.startsWith('{')) return { kind: 'text', text: part };
      if (inside.includes('|')) return { kind: 'either', text: inside };
      const metres = LENGTH.exec(inside)?.[1];
      if (metres) return { kind: 'text', text: shortLength(Number(metres), units) };
      return inside === 'wanting'
        ? { kind: 'text', text: failureText(conditions, units) || (held ? NO_BERTH_NEAR : NOTHING_NEAR) }
        : { kind: 'use', text: inside };
    });
}

/** A text in an element; it is written again only if it or the names of the keys have changed. */
export class MarkedText {
  private written = '';

  constructor(
    readonly element: HTMLElement,
    private readonly inHand: Pick<InHand, 'name' | 'kinds'>,
  ) {}

  set(text: readonly Piece[]): void {
    const written = `${this.inHand.kinds.join()} ${revision()} ${JSON.stringify(text)}`;
    if (written === this.written) return;
    this.written = written;
    this.element.replaceChildren(...text.map((piece) => this.node(piece)));
  }

  /** Returns a piece as a node: keys and quoted texts are emphasised. */
  private node({ kind, text }: Piece): Node | string {
    if (kind === 'text') return text;
    if (kind === 'either') return wordsFor(text, this.inHand);
    return kind === 'use' ? keyElement(this.inHand.name(text) || '–') : el('em', {}, text);
  }
}

/** Returns a text as a screen reader says it. */
export function saidText(text: readonly Piece[], inHand: Pick<InHand, 'name' | 'kinds'>): string {
  const said = ({ kind, text }: Piece) => {
    if (kind === 'either') return wordsFor(text, inHand);
    const name = kind === 'use' ? inHand.name(text) : text;
    return kind === 'use' ? (SPOKEN[name] ?? name) : name;
  };
  return text.map(said).join('');
}

/** Returns those of the words `keys|sticks` that fit the device in use. */
function wordsFor(text: string, { kinds }: Pick<InHand, 'kinds'>): string {
  const [keys = '', sticks = ''] = text.split('|');
  return kinds[0] === 'keyboard' ? keys : sticks;
}

/** Makes an element with the name of a key, button or axis. */
export function keyElement(name: string): HTMLElement {
  const spoken = SPOKEN[name];
  return el('b', spoken ? { role: 'img', 'aria-label': spoken } : {}, name);
}

/** Returns the text and the functions of the present step: its own, or those of the hint that applies. */
export function present(step: StepInfo, { hint }: TaskNow): HintInfo {
  return step.hints[hint] ?? step;
}

/** Returns a given length as a text, without superfluous zeros: `2 in`. */
function shortLength(metres: number, units: Units): string {
  return lengthText(metres, units).replace(/\.0+ /, ' ');
}

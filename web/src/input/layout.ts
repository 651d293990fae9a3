/**
 * Names of keys, buttons and axes. A letter key is named by the letter on the user's keyboard. The browser reports the
 * letters, or else they are learned when the keys are pressed.
 */

import { keeper } from '../page/local-storage';
import { type Kind, sourcesOf } from './mapping';
import { mappingOf } from './store';

const NAMES: Readonly<Record<string, string>> = {
  Space: 'Space',
  Enter: 'Enter',
  NumpadSubtract: 'Num −',
  NumpadMultiply: 'Num *',
  NumpadAdd: 'Num +',
  NumpadDivide: 'Num /',
  NumpadDecimal: 'Num .',
  Escape: 'Esc',
  ShiftLeft: 'Shift',
  ShiftRight: 'R Shift',
  Insert: 'Ins',
  Delete: 'Del',
  Minus: '−',
  Equal: '=',
  BracketLeft: '[',
  BracketRight: ']',
  Comma: ',',
  Period: '.',
  Slash: '/',
  Quote: '’',
  Backquote: '`',
  Semicolon: ';',
  Backslash: '\\',
  ArrowLeft: '←',
  ArrowRight: '→',
  ArrowUp: '↑',
  ArrowDown: '↓',
  PageUp: 'Page ↑',
  PageDown: 'Page ↓',
};

/** Names of a pad's buttons, in the order of the browser's standard mapping. */
const BUTTONS = [
  'South',
  'East',
  'West',
  'North',
  'L bumper',
  'R bumper',
  'L trigger',
  'R trigger',
  'View',
  'Menu',
  'L press',
  'R press',
  'Cross ↑',
  'Cross ↓',
  'Cross ←',
  'Cross →',
  'Home',
];

/** Abbreviations of the names in `BUTTONS`. */
const SHORT_BUTTONS = 'S E W N LB RB LT RT View Menu LP RP ✚↑ ✚↓ ✚← ✚→ Home'.split(' ');

/** Names of each axis, its two directions, and their abbreviations. */
type AxisWords = readonly [name: string, minus: string, plus: string, shortMinus: string, shortPlus: string];

const PAD_AXES: readonly AxisWords[] = [
  ['Left stick ↔', 'L stick ←', 'L stick →', 'L←', 'L→'],
  ['Left stick ↕', 'L stick ↑', 'L stick ↓', 'L↑', 'L↓'],
  ['Right stick ↔', 'R stick ←', 'R stick →', 'R←', 'R→'],
  ['Right stick ↕', 'R stick ↑', 'R stick ↓', 'R↑', 'R↓'],
];
const TOUCH_AXES: readonly AxisWords[] = [
  ...PAD_AXES.slice(0, 2),
  ['Left slider', 'L slider ↑', 'L slider ↓', 'LS↑', 'LS↓'],
  ...PAD_AXES.slice(2),
  ['Right slider', 'R slider ←', 'R slider →', 'RS←', 'RS→'],
];
const CAP_AXES: readonly AxisWords[] = [
  ['Cap ↔', 'Cap left', 'Cap right', '←', '→'],
  ['Cap ↕', 'Cap away', 'Cap near', '↑', '↓'],
  ['Cap height', 'Cap lifted', 'Cap pressed', 'lift', 'push'],
  ['Cap pitch', 'Cap tips away', 'Cap tips near', 'tip↑', 'tip↓'],
  ['Cap roll', 'Cap tips right', 'Cap tips left', 'tip→', 'tip←'],
  ['Cap twist', 'Cap twist ↺', 'Cap twist ↻', '↺', '↻'],
];

/** Storage key of the learned letters, for browsers that do not report the layout. */
const KEY = 'aftdeck.letters';
let letters: ReadonlyMap<string, string> = new Map();
let learned: Map<string, string> | null = null;

/** Returns the name of the key with this position code. */
export function nameOf(code: string): string {
  return (
    NAMES[code] ??
    (letters.get(code) ?? learnedLetters().get(code))?.toUpperCase() ??
    code.replace(/^(Key|Digit)/, '').replace(/^Numpad/, 'Num ')
  );
}

/** Returns the name of a key, button or axis; `sign`: direction of an axis. */
export function nameOfSource(kind: Kind, source: string, sign?: 1 | -1): string {
  if (kind === 'keyboard') return nameOf(source);
  if (source.includes('+'))
    return source
      .split('+')
      .map((part) => nameOfSource(kind, part))
      .join(' + ');
  const number = Number(source.slice(1));
  if (source[0] === 'a') {
    const words = axesOf(kind)[number] ?? [`Axis ${number}`, `Axis ${number} −`, `Axis ${number} +`];
    return words[sign === undefined ? 0 : sign < 0 ? 1 : 2];
  }
  return (kind.endsWith('pad') ? BUTTONS[number] : undefined) ?? `Button ${number + 1}`;
}

/** Returns the abbreviated name of a key, button or axis. */
export function shortOfSource(kind: Kind, source: string, sign: 1 | -1): string {
  if (kind === 'keyboard')
    return nameOf(source)
      .replace(/^Num /, 'N')
      .replace(/^Page /, 'P');
  if (source.includes('+'))
    return source
      .split('+')
      .map((part) => shortOfSource(kind, part, 1))
      .join('+');
  const number = Number(source.slice(1));
  if (source[0] !== 'a')
    return (kind.endsWith('pad') ? SHORT_BUTTONS[number] : undefined) ?? `B${number + 1}`;
  const words = axesOf(kind)[number];
  return words ? words[sign < 0 ? 3 : 4] : `${number}${sign < 0 ? '−' : '+'}`;
}

/** Returns the name of the first key that has this function; empty if there is none. */
export function keyOf(use: string): string {
  const code = sourcesOf(mappingOf('keyboard'), use)[0];
  return code === undefined ? '' : nameOf(code);
}

/** Asks the browser once for the layout, for `nameOf`. */
export async function learnLayout(): Promise<void> {
  const { keyboard } = navigator as Navigator & {
    keyboard?: { getLayoutMap(): Promise<ReadonlyMap<string, string>> };
  };
  letters = (await keyboard?.getLayoutMap().catch(() => undefined)) ?? letters;
}

type Pressed = Pick<KeyboardEvent, 'code' | 'key' | 'shiftKey' | 'ctrlKey' | 'altKey' | 'metaKey'>;

/** Learns the letter of a key that was pressed without Shift, Ctrl, Alt or Meta. */
export function learnLetter({ code, key, shiftKey, ctrlKey, altKey, metaKey }: Pressed): void {
  if (shiftKey || ctrlKey || altKey || metaKey || !/^Key[A-Z]$/.test(code) || !/^\S$/u.test(key)) return;
  if (letters.size > 0 || learnedLetters().get(code) === key.toLowerCase()) return;
  learnedLetters().set(code, key.toLowerCase());
  keeper.setItem(KEY, JSON.stringify([...learnedLetters()]));
}

/** Returns the letters learned in this and earlier visits. */
function learnedLetters(): Map<string, string> {
  learned ??= new Map(saved());
  return learned;
}

function saved(): [string, string][] {
  try {
    const kept: unknown = JSON.parse(keeper.getItem(KEY) ?? '[]');
    return Array.isArray(kept) ? kept.filter(isPair) : [];
  } catch {
    return []; // invalid data is replaced when letters are learned
  }
}

function isPair(pair: unknown): pair is [string, string] {
  return Array.isArray(pair) && pair.length === 2 && pair.every((each) => typeof each === 'string');
}

function axesOf(kind: Kind): readonly AxisWords[] {
  if (kind === 'touch') return TOUCH_AXES;
  if (kind === 'spacemouse') return CAP_AXES;
  return kind.endsWith('pad') ? PAD_AXES : [];
}

/** Changes of a mapping, and reasons to reject them. */

import { axisUse, labelOf, USES } from './keymap';
import { nameOfSource } from './layout';
import { indexOf, type Kind, type Mapping, MOST_OFFSET, sourcesOf } from './mapping';

/** A source that was pressed or moved; `sign`: direction of an axis. */
export interface Source {
  readonly source: string;
  readonly sign: 1 | -1;
}

/** Keys with a fixed function, and the sentence that rejects another function. */
const FIXED: ReadonlyMap<string, string> = new Map(
  [...USES.values()].flatMap(({ fixed, keys }) =>
    fixed === undefined ? [] : keys.map((key) => [key, `${fixed}: press another key.`] as const),
  ),
);

const BROWSERS = new Set([
  'Tab',
  'Backspace',
  'Slash',
  'Quote',
  'CapsLock',
  'NumLock',
  'ScrollLock',
  'ContextMenu',
]);
const BROWSERS_PATTERN =
  /^(?:F\d{1,2}|(?:Control|Alt|Meta|OS)(?:Left|Right)?|Print.*|Pause|Browser.*|Media.*|Audio.*)$/;

/** Returns whether the keys of a function are fixed, so that no other key can have this function. */
export function isFixed(kind: Kind, use: string): boolean {
  return kind === 'keyboard' && USES.get(use)?.fixed !== undefined;
}

/** Returns the reason why a key cannot be assigned, in a sentence; null if it can. */
export function keyRefusal(
  event: Pick<KeyboardEvent, 'code' | 'ctrlKey' | 'altKey' | 'metaKey'>,
): string | null {
  const { code } = event;
  if (event.ctrlKey || event.altKey || event.metaKey)
    return 'Keys with Ctrl, Alt or Meta belong to the browser: press a key alone.';
  const fixed = FIXED.get(code);
  if (fixed !== undefined) return fixed;
  if (BROWSERS.has(code) || BROWSERS_PATTERN.test(code))
    return `${nameOfSource('keyboard', code)} belongs to the browser: press another key.`;
  if (!/^[A-Z][A-Za-z0-9]{1,15}$/.test(code)) return 'This key has no position code: press another key.';
  return null;
}

/** Returns the other function that a source already has; null if it is free. */
export function otherUse(mapping: Mapping, use: string, { source }: Source): string | null {
  const before = mapping.bindings[source];
  return before === undefined || sameAxis(before, use, isAxis(source)) ? null : before;
}

/**
 * Returns a mapping in which the source that was pressed or moved has this function.
 *
 * Throws an Error with the reason for a rejection.
 */
export function bind(kind: Kind, mapping: Mapping, use: string, { source, sign }: Source): Mapping {
  const goal = goalOf(kind, use, { source, sign });
  const analogue = isAxis(source);
  const before = otherUse(mapping, use, { source, sign });
  if (before !== null) throw new Error(`${nameOfSource(kind, source)} is already “${labelOf(before)}”.`);
  const bindings: Record<string, string> = {};
  for (const [each, its] of Object.entries(mapping.bindings)) {
    const whole = (analogue || isAxis(each)) && sameAxis(its, use, true);
    if (each !== source && its !== use && !whole) bindings[each] = its;
  }
  bindings[source] = goal;
  return { ...mapping, bindings };
}

/**
 * Returns a mapping in which a source with another function has this function, and in which the former sources of this
 * function have the other one.
 *
 * Throws an Error with the reason for a rejection.
 */
export function exchange(kind: Kind, mapping: Mapping, use: string, { source, sign }: Source): Mapping {
  const goal = goalOf(kind, use, { source, sign });
  const other = otherUse(mapping, use, { source, sign });
  if (other === null) throw new Error(`${nameOfSource(kind, source)} has no other function.`);
  const former = movers(mapping, use).map((each) => each.source);
  const unlike = former.find((each) => isAxis(each) !== isAxis(source));
  if (unlike !== undefined)
    throw new Error(
      `${nameOfSource(kind, source)} is already “${labelOf(other)}”, which cannot move to ` +
        `${nameOfSource(kind, unlike)}: an axis and a button cannot be exchanged.`,
    );
  const bindings: Record<string, string> = { ...mapping.bindings, [source]: goal };
  for (const each of former) bindings[each] = mapping.bindings[each] === goal ? other : opposite(other);
  return { ...mapping, bindings };
}

/** Returns a mapping in which no source has this function. */
export function unbind(mapping: Mapping, use: string): Mapping {
  const removed = new Set(sourcesOf(mapping, use));
  for (const source of wholeAxes(mapping, use)) removed.add(source);
  const kept = Object.entries(mapping.bindings).filter(([source]) => !removed.has(source));
  return { ...mapping, bindings: Object.fromEntries(kept) };
}

/** Returns the sources of a function. Includes an axis with the opposite function; its `sign` is −1. */
export function movers(mapping: Mapping, use: string): readonly Source[] {
  const own = sourcesOf(mapping, use).map((source): Source => ({ source, sign: 1 }));
  const others = wholeAxes(mapping, use)
    .filter((source) => mapping.bindings[source] !== use)
    .map((source): Source => ({ source, sign: -1 }));
  return [...own, ...others];
}

/**
 * Returns a mapping in which the present positions of the axes are zero, and the axes that are too far from their
 * centres for this: they keep their zero.
 */
export function zeroed(
  mapping: Mapping,
  axes: readonly number[],
): { readonly mapping: Mapping; readonly far: readonly string[] } {
  const far: string[] = [];
  const centres = axes.map((value, axis) => {
    if (mapping.bindings[`a${axis}`] === undefined) return 0;
    if (Math.abs(value) <= MOST_OFFSET) return Math.round(value * 1000) / 1000;
    far.push(`a${axis}`);
    return mapping.centres[axis] ?? 0;
  });
  return { mapping: { ...mapping, centres }, far };
}

/** Returns the sentence after the present positions of the axes were set as zero, except those of the axes `far`. */
export function zeroWords(kind: Kind, far: readonly string[]): string {
  if (far.length === 0) return 'The present positions of the axes are now zero.';
  const names = far.map((source) => nameOfSource(kind, source)).join(', ');
  return (
    `The present positions of the axes are now zero, except ${names}: more than ${MOST_OFFSET} from the centre. ` +
    'Release it and set zero again, or remove its assignment.'
  );
}

/** Returns the function that a source gets: for an axis moved to its negative side, the opposite of `use`. */
function goalOf(kind: Kind, use: string, { source, sign }: Source): string {
  const does = USES.get(use)?.does;
  if (!does) throw new Error(`“${use}” is not a function.`);
  if (isAxis(source) && does.kind !== 'axis')
    throw new Error(`${nameOfSource(kind, source)} is an axis; “${labelOf(use)}” needs a button.`);
  return sign < 0 ? opposite(use) : use;
}

/** Returns the function that deflects an axis to its other side. */
function opposite(use: string): string {
  const does = USES.get(use)?.does;
  return does?.kind === 'axis' ? axisUse(does.axis, -does.sign) : use;
}

function isAxis(source: string): boolean {
  return indexOf(source, 'a') !== null;
}

function wholeAxes(mapping: Mapping, use: string): readonly string[] {
  return Object.entries(mapping.bindings)
    .filter(([source, its]) => isAxis(source) && sameAxis(its, use, true))
    .map(([source]) => source);
}

/** Returns whether two functions are equal. With `either`, the two directions of one axis also count as equal. */
function sameAxis(a: string, b: string, either: boolean): boolean {
  const [one, other] = [USES.get(a)?.does, USES.get(b)?.does];
  return a === b || (either && one?.kind === 'axis' && other?.kind === 'axis' && one.axis === other.axis);
}

/**
 * Types of the tables of functions that can be assigned to keys, buttons and axes; the code calls a function a `use`.
 * One entry in a table is all that the page has of a function: name, default keys, help, and what it does.
 */

import type { DeskGroup, Use as UseName, Welcome } from '../../link/protocol';
import type { Grip } from '../action';
import type { Acting, Viewing } from './acting';

export interface Use {
  /** Name in a mapping, and in the steps of a task: `+X`, `rate hold`, `camera 3`. */
  readonly name: UseName;
  /** Name on the page. */
  readonly label: string;
  /** Default keys, by their position on the keyboard. */
  readonly keys: readonly string[];
  readonly does: Does;
  /** Reason why these keys always have this function, as the start of a sentence; undefined if they can be changed. */
  readonly fixed?: string;
}

/**
 * Effect of a function: it deflects an axis to one side, acts once at each press (`view`: in secondary windows, too),
 * acts after a hold (`Grip`), or is PULSE: a key switches it on while it is held, and each press of a button switches it
 * on or off.
 */
export type Does =
  | { readonly kind: 'axis'; readonly axis: number; readonly sign: 1 | -1 }
  | { readonly kind: 'once'; act(page: Acting): void }
  | { readonly kind: 'view'; act(page: Viewing): void }
  | { readonly kind: 'grip'; readonly grip: Grip }
  | { readonly kind: 'pulse'; act(page: Acting): void };

/** What an arm and its worksite have. */
export interface Equipment {
  readonly work: Pick<Welcome['work'], 'hand' | 'stand'>;
  readonly flexures: readonly unknown[];
}

/** Functions that share a row of the key map. */
export interface Row {
  /** Effect of the functions, as the key map has it. */
  readonly help: string | ((of: Equipment) => string);
  readonly uses: readonly Use[];
  /** Functions whose keys the row shows, if not all of `uses`. */
  readonly caps?: readonly UseName[];
  /** Whether the row shows only the first and the last of its keys. */
  readonly range?: true;
  /** Group of the page with the displays of the functions. */
  readonly group?: DeskGroup | 'lens';
  /** Whether the row is shown; undefined: always. */
  readonly has?: (of: Equipment) => boolean;
}

/** Returns the rows that are shown for an arm and its worksite, each with its help. */
export function rowsFor(of: Equipment, rows: readonly Row[]): readonly (readonly [Row, help: string])[] {
  const shown = rows.filter(({ has }) => has?.(of) ?? true);
  return shown.map((row) => [row, typeof row.help === 'string' ? row.help : row.help(of)]);
}

export function once(act: (page: Acting) => void): Does {
  return { kind: 'once', act };
}

export function view(act: (page: Viewing) => void): Does {
  return { kind: 'view', act };
}

export function held(grip: Grip): Does {
  return { kind: 'grip', grip };
}

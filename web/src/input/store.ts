/** The present mapping of each kind of device, stored in the browser, and the number of changes. */

import { keeper } from '../page/local-storage';
import { DEFAULTS } from './defaults';
import { KINDS, type Kind, type Mapping, parseMapping } from './mapping';

const KEY = 'aftdeck.controllers.';

const present = new Map<Kind, Mapping>();
let changes = 0;
let troubles: string[] = [];

/** Number of changes of all mappings. A display of a mapping updates when this number changes. */
export function revision(): number {
  return changes;
}

/** Returns the present mapping of a kind: the saved mapping, or else the default. */
export function mappingOf(kind: Kind): Mapping {
  const known = present.get(kind);
  if (known) return known;
  const read = saved(kind) ?? DEFAULTS[kind];
  present.set(kind, read);
  return read;
}

/** Replaces the present mapping of a kind; returns false if the browser cannot store it. */
export function save(kind: Kind, mapping: Mapping): boolean {
  present.set(kind, mapping);
  changes += 1;
  return keeper.setItem(KEY + kind, JSON.stringify(mapping));
}

/** Restores the default mapping. */
export function restore(kind: Kind): void {
  present.set(kind, DEFAULTS[kind]);
  changes += 1;
  keeper.removeItem(KEY + kind);
}

/** Whether a mapping is the default. */
export function isDefault(kind: Kind): boolean {
  return mappingOf(kind) === DEFAULTS[kind];
}

/** Reads all saved mappings again; returns a sentence for each invalid one. */
export function reread(): readonly string[] {
  present.clear();
  troubles = [];
  for (const kind of KINDS) mappingOf(kind);
  return troubles;
}

function saved(kind: Kind): Mapping | null {
  const text = keeper.getItem(KEY + kind);
  if (text === null) return null;
  try {
    return parseMapping(JSON.parse(text));
  } catch (error) {
    const why = error instanceof Error ? error.message : error;
    troubles.push(`The saved mapping of the ${kind} is invalid, so the default is used: ${why}.`);
    return null;
  }
}

/** The mappings in use, kept in the browser, a kind of device at a time; and how often they have changed. */

import { keeper } from '../page/local-storage';
import { DEFAULTS } from './defaults';
import { KINDS, type Kind, type Mapping, parseMapping } from './mapping';

const KEY = 'aftdeck.controllers.';

const present = new Map<Kind, Mapping>();
let changes = 0;
let troubles: string[] = [];

/** Grows with each change, so that displays of the mappings know when to update. */
export function revision(): number {
  return changes;
}

/** What is in use for a kind: what was saved, else what the station comes with. */
export function mappingOf(kind: Kind): Mapping {
  const known = present.get(kind);
  if (known) return known;
  const read = saved(kind) ?? DEFAULTS[kind];
  present.set(kind, read);
  return read;
}

/** Uses a mapping from now on; false: a browser that keeps nothing forgets it with the page. */
export function save(kind: Kind, mapping: Mapping): boolean {
  present.set(kind, mapping);
  changes += 1;
  return keeper.setItem(KEY + kind, JSON.stringify(mapping));
}

/** Goes back to what the station comes with. */
export function restore(kind: Kind): void {
  present.set(kind, DEFAULTS[kind]);
  changes += 1;
  keeper.removeItem(KEY + kind);
}

/** Whether a mapping is what the station comes with. */
export function isDefault(kind: Kind): boolean {
  return mappingOf(kind) === DEFAULTS[kind];
}

/** Read everything again. Returns a sentence for each saved mapping that is not used. */
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
    troubles.push(`The saved mapping of the ${kind} is not used, it is as it came: ${why}.`);
    return null;
  }
}

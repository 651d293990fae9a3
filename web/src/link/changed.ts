/** Changes in flight: new values of fields of the welcome, which all parts of the page share. */

import type { Changed, Welcome } from './protocol';

/** Sets the changed fields of a welcome, in the objects that the parts of the page hold. */
export function renew(welcome: Welcome, { type: _, ...fields }: Changed): void {
  assign(welcome, fields);
}

/** Sets the fields of an object from another one; objects in it stay the same objects, with new fields. */
function assign(target: object, source: object): void {
  const into = target as Record<string, unknown>;
  for (const [name, value] of Object.entries(source)) {
    const now = into[name];
    if (isObject(now) && isObject(value)) assign(now, value);
    else into[name] = value;
  }
}

function isObject(value: unknown): value is object {
  return typeof value === 'object' && value !== null;
}

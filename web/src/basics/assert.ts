/** Never returns: the compiler proves that every case of a union was handled before it. */
export function assertUnreachable(value: never): never {
  throw new Error(`Not handled: ${JSON.stringify(value)}.`);
}

/** The item, or an error naming what was looked for. */
export function present<T>(item: T | null | undefined, what: string): T {
  if (item === null || item === undefined) throw new Error(`${what} is missing.`);
  return item;
}

/** Always throws. It accepts only `never`, so that the compiler proves that all other cases are handled earlier. */
export function assertUnreachable(value: never): never {
  throw new Error(`Not handled: ${JSON.stringify(value)}.`);
}

/** Returns the item, or throws an error if it is missing; `what` names the item in the error. */
export function present<T>(item: T | null | undefined, what: string): T {
  if (item === null || item === undefined) throw new Error(`${what} is missing.`);
  return item;
}

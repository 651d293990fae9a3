/** Always throws. It accepts only `never`: the compiler thus proves that all cases of a union were handled before. */
export function assertUnreachable(value: never): never {
  throw new Error(`Not handled: ${JSON.stringify(value)}.`);
}

/** Returns the item, or throws an error if it is missing; `what` names the item in the error. */
export function present<T>(item: T | null | undefined, what: string): T {
  if (item === null || item === undefined) throw new Error(`${what} is missing.`);
  return item;
}

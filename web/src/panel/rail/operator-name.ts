/** Names of pages: the user's name, or else the page's number. */

import type { Role } from '../../link/protocol';

type Names = Pick<Role, 'names'>;

/** Name within a sentence: `Anna`, `page 2`. */
export function called({ names }: Names, page: number): string {
  return named(names, page) ?? `page ${page}`;
}

/** Name at the start of a sentence: `Anna`, `Page 2`; empty for number 0. */
export function calledFirst({ names }: Names, page: number): string {
  if (page === 0) return '';
  return named(names, page) ?? `Page ${page}`;
}

function named(names: Role['names'], page: number): string | undefined {
  return names.find(({ number }) => number === page)?.name;
}

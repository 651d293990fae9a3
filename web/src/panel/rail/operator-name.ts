/** What pages are called: by the name of who sits there, else by their number. */

import type { Role } from '../../link/protocol';

type Names = Pick<Role, 'names'>;

/** In a sentence: `Anna`, `page 2`. */
export function called({ names }: Names, page: number): string {
  return named(names, page) ?? `page ${page}`;
}

/** At its beginning: `Anna`, `Page 2`; empty for 0, which is no page. */
export function calledFirst({ names }: Names, page: number): string {
  if (page === 0) return '';
  return named(names, page) ?? `Page ${page}`;
}

function named(names: Role['names'], page: number): string | undefined {
  return names.find(({ number }) => number === page)?.name;
}

/** Thumbnails of the scenarios, made by `scripts/thumbnails.py`; a user's own scenario has a neutral one. */

import own from './thumbnails/own.svg?inline';

const FILES = import.meta.glob<string>('./thumbnails/*.webp', {
  query: '?inline',
  import: 'default',
  eager: true,
});

/** Returns the address of a scenario's picture; `given`: whether the scenario is the user's own. */
export function thumbnail(name: string, given: boolean): string {
  return given ? own : (FILES[`./thumbnails/${name}.webp`] ?? own);
}

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { ROOM } from '../src/page/room';

const SOURCES = join(import.meta.dirname, '../src');

/** Every `@media` and `@container` of the style sheets. */
function queries(): string[] {
  const sheets = readdirSync(SOURCES, { recursive: true, encoding: 'utf8' }).filter((name) =>
    name.endsWith('.css'),
  );
  return sheets.flatMap(
    (name) => readFileSync(join(SOURCES, name), 'utf8').match(/@(media|container)[^{]*/g) ?? [],
  );
}

test('a style sheet asks for room by name, and every name is used', () => {
  const names = queries().flatMap((query) => [...query.matchAll(/\(--(\w+)\)/g)].map(([, name]) => name));
  expect(new Set(names)).toEqual(new Set(Object.keys(ROOM)));
});

test('no style sheet repeats a breakpoint', () => {
  expect(queries().filter((query) => /\d/.test(query))).toEqual([]);
});

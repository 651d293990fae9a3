import { expect, test } from 'vitest';
import { ROOM } from '../src/page/room';

const SHEETS = import.meta.glob<string>('../src/**/*.css', { query: '?raw', import: 'default', eager: true });

/** Every `@media` and `@container` of the style sheets. */
const QUERIES = Object.values(SHEETS).flatMap((sheet) => sheet.match(/@(media|container)[^{]*/g) ?? []);

test('every breakpoint has a name, and every name is used', () => {
  const names = QUERIES.flatMap((query) => [...query.matchAll(/\(--(\w+)\)/g)].map(([, name]) => name));
  expect(new Set(names)).toEqual(new Set(Object.keys(ROOM)));
});

test('no style sheet repeats a breakpoint', () => {
  expect(QUERIES.filter((query) => /\d/.test(query))).toEqual([]);
});

import { describe, expect, test, vi } from 'vitest';
import keysDocument from '../../docs/keys.md?raw';
import { ROWS, USES } from '../src/input/keymap';
import { nameOf } from '../src/input/layout';
import type { Acting } from '../src/input/uses/acting';
import { rowsFor } from '../src/input/uses/use';

const EQUIPMENT = [
  { work: { hand: 'snares', stand: null }, flexures: [] },
  { work: { hand: 'prong', stand: {} as never }, flexures: [{}] },
] as const;

/** Returns a page whose parts, at any depth, count their calls. */
function page(called: () => void): Acting {
  const part: object = new Proxy(() => {}, {
    get: (_, name) => (name === 'frame' ? null : part),
    apply: () => called(),
  });
  return part as Acting;
}

describe('the tables of functions', () => {
  const listed = ROWS.flatMap(({ uses }) => uses);

  test('name each function and each default key once', () => {
    const keys = listed.flatMap((use) => use.keys);
    for (const names of [listed.map(({ name }) => name), keys])
      expect(new Set(names).size).toBe(names.length);
  });

  test('have a help for each function, on every arm', () => {
    for (const of of EQUIPMENT) for (const [, help] of rowsFor(of, ROWS)) expect(help).toMatch(/\S/);
  });

  test('have one command for each function that acts at a press', () => {
    for (const { does, name } of listed) {
      if (does.kind === 'axis' || does.kind === 'grip') continue;
      const called = vi.fn();
      does.act(page(called));
      expect(called, name).toHaveBeenCalledTimes(1);
    }
  });

  test('have a label for each function', () => {
    for (const { label } of USES.values()) expect(label).toMatch(/\S/);
  });
});

/** Returns the names of the keys in the tables of the section “Keyboard”. */
function documented(): ReadonlySet<string> {
  const [, section = ''] = /\n## Keyboard\n(.*?)\n## /s.exec(keysDocument) ?? [];
  const rows = section.split('\n').filter((line) => line.startsWith('|'));
  const names = rows.flatMap((row) => [...row.matchAll(/\*\*((?:\\.|[^*])+)\*\*|`` (.) ``/g)]);
  return new Set(names.map(([, bold, code]) => bold?.replace(/\\(.)/g, '$1') ?? code ?? ''));
}

describe('docs/keys.md', () => {
  test('lists the default key of each function', () => {
    const between = /^camera [2-9]$/; // the document lists a range
    for (const { name, keys } of USES.values())
      if (!between.test(name)) expect(documented(), name).toContain(nameOf(keys[0] ?? ''));
  });

  test('lists no key without a function', () => {
    const names = new Set([...USES.values()].flatMap(({ keys }) => keys.map(nameOf)));
    for (const name of documented()) if (name !== '?') expect(names).toContain(name);
  });
});

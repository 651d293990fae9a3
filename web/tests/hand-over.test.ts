import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { Role } from '../src/link/protocol';
import { handOver } from '../src/panel/rail/hand-over';
import { useSmallPage } from './small-page';

beforeEach(useSmallPage);

afterEach(() => {
  vi.unstubAllGlobals();
});

const OPERATOR: Role = {
  ...{ type: 'role', flying: true, may_fly: true, watchers: 0, number: 1, flier: 1, asking: 0 },
  ...{ name: '', names: [] },
};

test.each<[Partial<Role>, string]>([
  [{}, 'You fly'],
  [{ watchers: 1 }, 'You fly · 1 observes'],
  [{ watchers: 2 }, 'You fly · 2 observe'],
  [{ watchers: 1, names: [{ number: 2, name: 'Anna' }] }, 'You fly · Anna observes'],
  [{ flying: false, number: 2 }, 'Observing · page 1 flies'],
  [{ flying: false, number: 2, flier: 0 }, 'Observing · unattended'],
])('the rail of a page with %j has the text “%s”', (changes, text) => {
  expect(handOver(() => {}).words({ ...OPERATOR, ...changes }, 0)).toBe(text);
});

test('only a page that can take control and is not in control has the button that asks for control', () => {
  const { ask, words } = handOver(() => {});
  const hidden = (changes: Partial<Role>) => {
    words({ ...OPERATOR, ...changes }, 0);
    return ask.hidden;
  };
  expect(hidden({})).toBe(true);
  expect(hidden({ flying: false, number: 2 })).toBe(false);
  expect(hidden({ flying: false, number: 2, may_fly: false })).toBe(true);
  expect(hidden({ flying: false, number: 0 })).toBe(true); // a secondary window
});

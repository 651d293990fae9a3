import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { Level } from '../src/link/protocol';
import { KEPT_MS, Spine } from '../src/panel/spine/spine';
import { small, useSmallPage } from './small-page';

beforeEach(useSmallPage);

afterEach(() => {
  vi.unstubAllGlobals();
});

/** Lamps whose master alarm acknowledges them. `alarm` shows the lamp CLEARANCE and returns the state of the alarm. */
function lamps() {
  const spine: Spine = new Spine({ acknowledged: () => spine.acknowledge(), pressed() {} });
  const master = small(spine.element).querySelector('button.master');
  return {
    master,
    alarm(level?: Level, standing = false) {
      spine.show(level ? [{ name: 'CLEARANCE', level, text: 'near', standing }] : []);
      const lit = (['caution', 'warning'] as const).filter((name) => master?.classes.includes(name));
      return [...lit, ...(master?.textContent.includes('press') ? ['unacknowledged'] : [])];
    },
  };
}

test('an acknowledged caution alarms again when it becomes a warning, but not when it becomes a caution again', () => {
  const { alarm, master } = lamps();
  expect(alarm('caution')).toEqual(['caution', 'unacknowledged']);
  master?.click();
  expect(alarm('caution')).toEqual([]);
  expect(alarm('warning')).toEqual(['warning', 'unacknowledged']);
  expect(alarm('caution')).toEqual(['caution', 'unacknowledged']); // the warning is not acknowledged yet
  master?.click();
  expect(alarm('caution')).toEqual([]);
});

test('the alarm of an unacknowledged lamp ends with the lamp', () => {
  const { alarm } = lamps();
  expect(alarm('warning')).toEqual(['warning', 'unacknowledged']);
  expect(alarm()).toEqual([]);
  expect(alarm('caution')).toEqual(['caution', 'unacknowledged']);
});

test('an information, and a lamp that is lit since the run began, raise no alarm', () => {
  expect(lamps().alarm('info')).toEqual([]);
  expect(lamps().alarm('caution', true)).toEqual([]);
});

test('the calm page keeps the spine for a while after its last lamp, but not over a restart', () => {
  let now = 0;
  vi.spyOn(performance, 'now').mockImplementation(() => now);
  const spine: Spine = new Spine({ acknowledged() {}, pressed() {} });
  const kept = () => small(spine.element).classes.includes('lit-lately');
  const shown = (at: number, level?: Level) => {
    now = at;
    spine.show(level ? [{ name: 'CLEARANCE', level, text: 'near', standing: false }] : []);
    return kept();
  };
  expect(shown(1)).toBe(false);
  expect(shown(2, 'info')).toBe(false);
  expect(shown(3, 'caution')).toBe(true);
  expect(shown(2 + KEPT_MS)).toBe(true);
  expect(shown(4 + KEPT_MS)).toBe(false);
  expect(shown(5 + KEPT_MS, 'warning')).toBe(true);
  spine.forget();
  expect(shown(6 + KEPT_MS)).toBe(false);
  vi.restoreAllMocks();
});

import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { Hold } from '../src/input/hold';
import { type Equipment, rowsFor } from '../src/input/uses/use';
import { WORKING } from '../src/input/uses/working';
import { isMoving } from '../src/panel/desk/orbiter';
import { counted } from '../src/panel/spine/spine';

beforeEach(() => {
  vi.useFakeTimers();
});

afterEach(() => {
  vi.useRealTimers();
});

test('the master alarm counts warnings and cautions separately', () => {
  const lit = (...levels: ('info' | 'caution' | 'warning')[]) => counted(levels.map((level) => ({ level })));
  expect(lit()).toBe('');
  expect(lit('info')).toBe('');
  expect(lit('caution', 'info')).toBe('1 caution');
  expect(lit('caution', 'warning', 'caution')).toBe('1 warning, 2 cautions');
});

test('a held switch acts once, after its hold time', () => {
  const acted = vi.fn();
  const hold = new Hold(0.3, acted);
  hold.press(1000);
  expect(hold.tick(1150)).toBeCloseTo(0.5);
  expect(acted).not.toHaveBeenCalled();
  hold.tick(1310);
  hold.tick(1900);
  hold.lift(2000);
  expect(acted).toHaveBeenCalledTimes(1);
  hold.press(3000);
  hold.lift(3200);
  expect(acted).toHaveBeenCalledTimes(1);
});

test('a switch that is held long enough acts at its release, even without a call of `tick`', () => {
  const acted = vi.fn();
  const hold = new Hold(0.3, acted);
  hold.press(1000);
  hold.lift(1400);
  expect(acted).toHaveBeenCalledTimes(1);
});

test('a switch acts at the second call of `tick` after its hold time if the page is slow', () => {
  const acted = vi.fn();
  const hold = new Hold(0.3, acted);
  hold.press(1000);
  expect([hold.tick(1500), acted.mock.calls.length]).toEqual([1, 0]);
  expect([hold.tick(2000), acted.mock.calls.length]).toEqual([1, 1]);
  hold.tick(2500);
  hold.lift(3000);
  expect(acted).toHaveBeenCalledTimes(1);
});

test('the orbiter is at rest below 0.1 mm/s', () => {
  expect(isMoving({ orbiter_velocity: [0, 5e-5, 0] })).toBe(false);
  expect(isMoving({ orbiter_velocity: [0, 0, -0.01] })).toBe(true);
});

test('the key map lists only the keys of the present arm', () => {
  const keyMap = (hand: 'prong' | 'snares', stand: object | null) =>
    rowsFor({ flexures: [], work: { hand, stand } } as unknown as Equipment, WORKING)
      .map(([, help]) => help)
      .join();
  expect(keyMap('snares', null)).not.toMatch(/prong|telescope/);
  expect(keyMap('prong', {})).toMatch(/prong.*telescope/);
  expect(keyMap('prong', {})).not.toMatch(/capture/);
});

import { beforeEach, expect, test, vi } from 'vitest';
import { LOST } from '../src/cameras/drawers';
import { Putting } from '../src/cameras/putting';
import type { Put } from '../src/scene';

const FAULT = new Error('a fault');

let put: Put;
let failed: unknown[];
let later: () => void;
let putting: Putting;
let slow: () => void;

beforeEach(() => {
  vi.stubGlobal('window', {
    setTimeout(act: () => void) {
      later = act;
      return 0;
    },
  });
  [put, failed, slow] = ['drawn', [], () => {}];
  putting = new Putting(
    () => put,
    (error) => failed.push(error),
    () => slow(),
  );
});

function breaks(): never {
  throw FAULT;
}

test('pictures that are pending are put later, and then counted once', () => {
  const done = vi.fn();
  put = 'pending';
  putting.start(0, () => true, done);
  later();
  expect([putting.waits, done.mock.calls.length]).toEqual([true, 0]);
  put = 'drawn';
  later();
  later();
  expect([putting.waits, done.mock.calls.length]).toEqual([false, 1]);
});

test('pictures that show nothing, are lost or given up are not counted', () => {
  const done = vi.fn();
  putting.start(0, () => false, done);
  put = 'lost';
  putting.start(0, () => true, done);
  expect([failed, putting.waits]).toEqual([[LOST], false]);
  put = 'pending';
  putting.start(0, () => true, done);
  putting.stop();
  put = 'drawn';
  later();
  expect([done.mock.calls.length, putting.waits]).toEqual([0, false]);
});

test.each(['drawn', 'pending'] as const)('an error of the page is not blamed on %s pictures', (first) => {
  const run = (...given: Parameters<Putting['start']>) => {
    put = first;
    const start = () => putting.start(...given);
    if (first === 'drawn') return start;
    start();
    put = 'drawn';
    return later;
  };
  expect(run(0, () => true, breaks)).toThrow(FAULT);
  expect([failed, putting.waits]).toEqual([[], false]);
  run(0, breaks, () => {})();
  expect([failed, putting.waits]).toEqual([[FAULT], false]);
});

test('the next pictures can be drawn when the last ones are counted', () => {
  const counted: string[] = [];
  const next = () =>
    putting.start(
      0,
      () => true,
      () => counted.push('second'),
    );
  putting.start(
    0,
    () => true,
    () => {
      counted.push('first');
      next();
    },
  );
  expect(counted).toEqual(['first', 'second']);
});

test('pictures that take more than two seconds are slow, and can be given up', () => {
  vi.spyOn(performance, 'now').mockReturnValueOnce(1900).mockReturnValueOnce(2100);
  const [done, gaveUp] = [vi.fn(), vi.fn()];
  slow = () => {
    gaveUp();
    putting.stop();
  };
  put = 'pending';
  putting.start(0, () => true, done);
  expect(gaveUp).not.toHaveBeenCalled();
  put = 'drawn';
  later();
  expect([gaveUp.mock.calls.length, done.mock.calls.length, putting.waits]).toEqual([1, 0, false]);
  vi.restoreAllMocks();
});

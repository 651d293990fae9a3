import { describe, expect, it, test } from 'vitest';
import { PAN, X } from '../src/input/deflection';
import { routed, Sticks } from '../src/input/sticks';

test('the THC moves either the arm or the orbiter', () => {
  const value = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7];
  const rest = { rotation: [0.4, 0.5, 0.6], drive: 0, telescope: 0.7 };
  expect(routed(value, false, false)).toEqual({ ...rest, translation: [0.1, 0.2, 0.3], orbiter: [0, 0, 0] });
  expect(routed(value, false, true)).toEqual({ ...rest, translation: [0, 0, 0], orbiter: [0.1, 0.2, 0.3] });
});

test('X drives the selected joint unless the THC flies the orbiter', () => {
  const value = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0];
  expect(routed(value, true, false)).toMatchObject({
    translation: [0, 0, 0],
    rotation: [0, 0, 0],
    drive: 0.1,
  });
  expect(routed(value, true, true)).toMatchObject({ drive: 0, orbiter: [0.1, 0.2, 0.3] });
});

describe('stick to picture', () => {
  const still = Array.from({ length: 10 }, () => 0);
  /**
   * Sticks that read their deflections from `at`, not from devices. `inputTimes` lists the input time of each message
   * whose latency is measured.
   */
  function stickOf(at: { value: readonly number[]; moved: boolean }) {
    const inputTimes: number[] = [];
    const latency = { sent: (_seq: number, from: number) => inputTimes.push(from) };
    const controllers = {
      poll: () => at.value,
      release() {},
      pulses: { asks: false },
      get moved() {
        return at.moved;
      },
    };
    const sticks = new Sticks(controllers as never, latency as never, () => 0);
    return { sticks, inputTimes };
  }
  const deflected = (axis: number, value: number) => still.map((rest, i) => (i === axis ? value : rest));

  it('is measured from the input that moved a stick, not from a camera key', () => {
    const at = { value: deflected(PAN, 1), moved: false };
    const { sticks, inputTimes } = stickOf(at);
    sticks.moved(1000); // a camera's key
    at.value = still;
    sticks.tick(2000);
    at.value = deflected(X, 0.5);
    sticks.moved(6000);
    expect(inputTimes).toEqual([6000]);
  });

  it('is not measured for a device that moves while its deflections are still zero', () => {
    const at = { value: still, moved: true };
    const { sticks, inputTimes } = stickOf(at);
    sticks.tick(1000);
    sticks.tick(1015);
    [at.value, at.moved] = [deflected(X, 0.5), true];
    sticks.tick(4000);
    at.moved = false;
    sticks.tick(4200); // repeated while it is held
    expect(inputTimes).toEqual([4000]);
  });
});

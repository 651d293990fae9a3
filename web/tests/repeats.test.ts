import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { Action } from '../src/input/action';
import { Keyboard } from '../src/input/keyboard';

/** Time between two readings of the keyboard, time to the first repeat of a key, and time between two repeats [ms]. */
const [TICK_MS, FIRST_MS, REPEAT_MS] = [15, 500, 33];

let around: EventTarget;

beforeEach(() => {
  around = new EventTarget();
  vi.stubGlobal('window', around);
  for (const name of ['HTMLElement', 'HTMLInputElement']) vi.stubGlobal(name, class {});
});

afterEach(() => vi.unstubAllGlobals());

/** A page, and hands that press keys. `repeats`: whether the system repeats the key that was pressed last. */
function desk({ repeats = true } = {}) {
  const acted: Action[] = [];
  const keyboard = new Keyboard({ moved() {}, acted: (action) => acted.push(action), taken: () => false });
  let now = 0;
  let last: { code: string; next: number } | null = null;
  /** Events that the stalled page has not received yet; null while it runs. */
  let queue: Event[] | null = null;
  const send = (type: 'keydown' | 'keyup', code: string, repeat = false, at = now) => {
    const event = Object.assign(new Event(type), { code, key: '', repeat });
    Object.defineProperty(event, 'timeStamp', { value: at });
    if (queue) queue.push(event);
    else around.dispatchEvent(event);
  };
  /** Lets time pass; `runs`: whether the page does anything meanwhile. */
  const wait = (time: number, runs = true) => {
    if (!runs) queue = [];
    for (const end = now + time; now < end; now += TICK_MS) {
      for (; last && repeats && last.next <= now; last.next += REPEAT_MS)
        send('keydown', last.code, true, last.next);
      if (runs) keyboard.step(TICK_MS / 1000, now);
    }
  };
  return {
    acted,
    wait,
    press(code: string) {
      send('keydown', code);
      last = { code, next: now + FIRST_MS };
    },
    /** Releases a key; `reported`: whether its release reaches the page. */
    release(code: string, reported = true) {
      if (reported) send('keyup', code);
      if (last?.code === code) last = null;
    },
    /** Lets the page stand still. Then it first reads the keyboard, and receives the events of this time after that. */
    stall(time: number) {
      wait(time, false);
      keyboard.step(0.1, now);
      const events = queue ?? [];
      queue = null;
      for (const event of events) around.dispatchEvent(event);
    },
    /** Returns the deflections along X and Y. */
    xy: () => keyboard.value.slice(0, 2),
  };
}

test('a key whose release was lost is released a second after its last repeat', () => {
  const { press, release, wait, xy } = desk();
  press('KeyW');
  wait(2000);
  expect(xy()).toEqual([1, 0]);
  release('KeyW', false);
  wait(900);
  expect(xy()).toEqual([1, 0]);
  wait(400);
  expect(xy()).toEqual([0, 0]);
});

test('a key that is held goes on while another is tapped, and for 10 s after that', () => {
  const { press, release, wait, xy } = desk();
  press('KeyW');
  wait(2000);
  press('KeyD');
  wait(100);
  release('KeyD');
  wait(10_000);
  expect(xy()).toEqual([1, 0]);
});

test('a key without a function counts as another key, too', () => {
  const { press, release, wait, xy } = desk();
  press('KeyW');
  wait(2000);
  press('ShiftLeft');
  release('ShiftLeft');
  wait(10_000);
  expect(xy()).toEqual([1, 0]);
});

test('two keys that are held go on for 10 s, and one of them when the other is released', () => {
  const { press, release, wait, xy } = desk();
  press('KeyW');
  wait(1000);
  press('KeyD');
  wait(10_000);
  expect(xy()).toEqual([1, 1]);
  release('KeyD');
  wait(10_000);
  expect(xy()).toEqual([1, 0]);
});

test('a held key goes on for 10 s on a system without repeats', () => {
  const { press, wait, xy } = desk({ repeats: false });
  press('KeyW');
  wait(10_000);
  expect(xy()).toEqual([1, 0]);
});

test.each([500, 1500, 3000, 20_000])('a held key goes on after the page stood still for %i ms', (time) => {
  const { press, wait, stall, xy } = desk();
  press('KeyW');
  wait(2000);
  stall(time);
  expect(xy()).toEqual([1, 0]);
  wait(3000);
  expect(xy()).toEqual([1, 0]);
});

test('a repeat that arrives later presses the key again', () => {
  const { press, release, wait, xy } = desk();
  press('KeyW');
  wait(2000);
  release('KeyW', false);
  wait(2000);
  expect(xy()).toEqual([0, 0]);
  around.dispatchEvent(Object.assign(new Event('keydown'), { code: 'KeyW', key: '', repeat: true }));
  wait(500);
  expect(xy()).toEqual([1, 0]);
});

test('a switch whose repeats stop is released, and not pressed again by a repeat', () => {
  const { acted, press, release, wait } = desk();
  const grips = () => acted.flatMap((action) => (action.name === 'grip' ? [action.down] : []));
  press('KeyR');
  wait(2000);
  release('KeyR', false);
  wait(2000);
  expect(grips()).toEqual([true, false]);
  around.dispatchEvent(Object.assign(new Event('keydown'), { code: 'KeyR', key: '', repeat: true }));
  expect(grips()).toEqual([true, false]);
});

import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { Latency } from '../src/link/latency';
import type { Command } from '../src/link/socket';
import { Operator } from '../src/page/operator';

beforeEach(() => {
  vi.useFakeTimers(); // `run` sets the time
});

afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

/** Time between two readings of the devices [ms]. */
const TICK_MS = 15;

/** The operator's inputs on a page whose events and time come from the test. */
function operator() {
  const page = Object.assign(new EventTarget(), { hidden: false });
  const around = Object.assign(new EventTarget(), { setInterval: () => 0 });
  vi.stubGlobal('document', page);
  vi.stubGlobal('window', around);
  vi.stubGlobal('navigator', { getGamepads: () => [] });
  for (const name of ['HTMLElement', 'HTMLInputElement']) vi.stubGlobal(name, class {});
  const sent: Command[] = [];
  const inputs = new Operator({ sent() {} } as unknown as Latency, {
    acted() {},
    send: (command) => sent.push(command),
    taken: () => false,
    pressedInVain() {},
  });
  inputs.flying = true;
  let now = 1000;
  return {
    ...{ inputs, page, around, sent },
    key(type: 'keydown' | 'keyup', code: string, key = '') {
      around.dispatchEvent(Object.assign(new Event(type), { code, key, repeat: false }));
    },
    /** Lets the page be blocked for a time [ms]. */
    block(time: number) {
      now += time;
      inputs.tick(now);
    },
    /** Returns the THC's deflection along X half a second later. */
    x() {
      for (const end = now + 500; now < end; now += TICK_MS) inputs.tick(now);
      return inputs.sticks.value[0];
    },
  };
}

test.each<[string, (made: ReturnType<typeof operator>) => void]>([
  [
    'is hidden',
    ({ page }) => {
      page.hidden = true;
      page.dispatchEvent(new Event('visibilitychange'));
      page.hidden = false;
    },
  ],
  ['loses the focus', ({ around }) => around.dispatchEvent(new Event('blur'))],
  ['receives Meta', ({ key }) => key('keydown', 'MetaLeft', 'Meta')],
  ['receives the release of Meta', ({ key }) => key('keyup', 'MetaLeft', 'Meta')],
  ['is left', ({ around }) => around.dispatchEvent(new Event('pagehide'))],
  ['was blocked for more than 2 s', ({ block }) => block(2100)],
])('a page that %s centres the sticks at once; a held key acts only when pressed again', (_, leave) => {
  const made = operator();
  made.key('keydown', 'KeyW');
  expect(made.x()).toBe(1);
  leave(made);
  expect(made.sent.filter(({ type }) => type === 'sticks').at(-1)).toMatchObject({ translation: [0, 0, 0] });
  expect(made.x()).toBe(0);
  made.key('keyup', 'KeyW');
  made.key('keydown', 'KeyW');
  expect(made.x()).toBe(1);
  made.inputs.dispose();
});

test('only the hidden page of the operator reports that it is hidden', () => {
  const made = operator();
  const hide = () => {
    made.page.hidden = true;
    made.page.dispatchEvent(new Event('visibilitychange'));
  };
  hide();
  expect(made.sent).toEqual([{ type: 'hands_off', cause: 'page hidden' }]);
  made.inputs.flying = false;
  hide();
  expect(made.sent).toHaveLength(1);
  made.inputs.dispose();
});

test('the sticks of an observer are not sent', () => {
  const made = operator();
  made.inputs.flying = false;
  made.key('keydown', 'KeyW');
  expect(made.x()).toBe(0);
  expect(made.sent).toEqual([]);
  made.inputs.dispose();
});

test('a page that was blocked for less than 2 s goes on', () => {
  const made = operator();
  made.key('keydown', 'KeyW');
  expect(made.x()).toBe(1);
  made.block(1500);
  expect(made.inputs.sticks.value[0]).toBe(1);
  made.inputs.dispose();
});

import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { Pictures } from '../src/cameras/pictures';
import type { Welcome } from '../src/link/protocol';
import { Control } from '../src/page/control';
import { WindowLink } from '../src/page/window-link';
import type { WindowMessage } from '../src/windows/opened';
import { bay } from './camera-values';

/** Channel of the page; the test acts as the secondary windows. */
class FakeChannel {
  readonly told: WindowMessage[] = [];
  open = true;
  private hear: (event: { data: WindowMessage }) => void = () => {};
  addEventListener = (_: string, hear: (event: { data: WindowMessage }) => void) => {
    this.hear = hear;
  };
  postMessage = (message: WindowMessage) => void this.told.push(message);
  close = () => {
    this.open = false;
  };
  receive = (message: WindowMessage) => this.hear({ data: message });
}

let channels: FakeChannel[];
let keys: string[];

beforeEach(() => {
  vi.useFakeTimers();
  [channels, keys] = [[], []];
  vi.stubGlobal(
    'BroadcastChannel',
    class extends FakeChannel {
      constructor() {
        super();
        channels.push(this);
      }
    },
  );
  vi.stubGlobal('window', { addEventListener() {}, setInterval });
  vi.stubGlobal(
    'KeyboardEvent',
    class {
      constructor(
        readonly type: string,
        readonly init: { readonly code: string },
      ) {}
    },
  );
  type Key = { readonly type: string; readonly init: { readonly code: string } };
  const dispatchEvent = ({ type, init }: Key) => keys.push(`${type} ${init.code}`);
  vi.stubGlobal('document', { body: { dispatchEvent } });
});

afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

/** A page with a channel to its windows; MON 1 is selected. */
function opened(flying = true) {
  const control = new Control();
  control.role = { ...control.role, flying };
  const both = [{}, {}];
  const monitors = {
    both,
    hand: both[0],
    shown: [['A'], ['B', 'C']],
    ...{ show: vi.fn(), choose: vi.fn(), take: vi.fn() },
  };
  const centre = vi.fn();
  const link = new WindowLink(
    { cameras: [bay] } as unknown as Welcome,
    { monitors, showsPlane: true } as unknown as Pictures,
    control,
    () => 'SI',
    centre,
  );
  const channel = channels.at(-1) as FakeChannel;
  return { monitors, centre, link, channel };
}

const key = (down: boolean): WindowMessage => ({
  ...{ kind: 'key', down, repeat: false, code: 'KeyW', key: 'w', shift: false },
});

test.each([true, false])('a window that asks receives the state of the page; in control: %s', (flying) => {
  const { channel } = opened(flying);
  channel.receive({ kind: 'ask' });
  const monitors = [['A'], ['B', 'C']];
  expect(channel.told).toEqual([{ kind: 'page', monitors, plane: true, units: 'SI', takesKeys: flying }]);
});

test('a window changes the cameras of a monitor, also for an observer', () => {
  for (const flying of [true, false]) {
    const { channel, monitors } = opened(flying);
    channel.receive({ kind: 'show', monitor: 1, names: ['B'] });
    expect(monitors.show.mock.calls).toEqual([[1, ['B']]]);
  }
});

test('a window puts only cameras of the scenario on the selected monitor', () => {
  const { channel, monitors } = opened();
  channel.receive({ kind: 'put', name: 'none of them' });
  expect(monitors.choose).not.toHaveBeenCalled();
  channel.receive({ kind: 'put', name: bay.name });
  expect(monitors.choose.mock.calls).toEqual([[bay]]);
});

test('the window of a monitor selects this monitor in an operator’s page, unless it is already selected', () => {
  const { channel, monitors } = opened();
  channel.receive({ kind: 'take', monitor: 0 });
  expect(monitors.take).not.toHaveBeenCalled();
  channel.receive({ kind: 'take', monitor: 1 });
  expect(monitors.take.mock.calls).toEqual([[1]]);
  const observer = opened(false);
  observer.channel.receive({ kind: 'take', monitor: 1 });
  expect(observer.monitors.take).not.toHaveBeenCalled();
});

test('keys of a window act only in the page in control', () => {
  const { channel } = opened();
  channel.receive(key(true));
  channel.receive(key(false));
  expect(keys).toEqual(['keydown KeyW', 'keyup KeyW']);
  opened(false).channel.receive(key(true));
  expect(keys).toHaveLength(2);
});

test('sticks are centred when a window releases all keys', () => {
  const { centre, channel } = opened();
  channel.receive(key(true));
  expect(centre).not.toHaveBeenCalled();
  channel.receive({ kind: 'released' });
  expect(centre).toHaveBeenCalledTimes(1);
});

test('sticks are centred once when a window with held keys is silent for 0.5 s', () => {
  const { centre, channel } = opened();
  channel.receive(key(true));
  for (let sent = 0; sent < 10; sent += 1) {
    vi.advanceTimersByTime(450);
    channel.receive({ kind: 'holding' });
  }
  expect(centre).not.toHaveBeenCalled();
  vi.advanceTimersByTime(2000);
  expect(centre).toHaveBeenCalledTimes(1);
});

test('windows learn that their page closes', () => {
  const { channel, link } = opened();
  link.gone();
  expect(channel.told).toEqual([{ kind: 'gone' }]);
});

test('a disposed link closes its channel and centres no sticks', () => {
  const { centre, channel, link } = opened();
  channel.receive(key(true));
  link.dispose();
  expect(channel.open).toBe(false);
  vi.advanceTimersByTime(2000);
  expect(centre).not.toHaveBeenCalled();
});

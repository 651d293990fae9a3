import { expect, it } from 'vitest';
import type { Controllers } from '../src/input/controllers';
import type { Command } from '../src/link/socket';
import { DeviceWatch } from '../src/page/device-watch';

function station() {
  const devices = {
    lost: [] as { short: string }[],
    revision: 'keys',
    inUse: () => [],
    faults: [] as string[],
  };
  const sent: Command['type'][] = [];
  const levels: string[] = [];
  const watch = new DeviceWatch(devices as unknown as Controllers, {
    send: ({ type }) => sent.push(type),
    say: (_, level) => levels.push(level),
  });
  return { devices, sent, levels, watch };
}

it('devices are reported once for each change', () => {
  const { devices, sent, watch } = station();
  watch.watch(true, true);
  watch.watch(true, true);
  expect(sent).toEqual(['controllers']);
  devices.revision = 'keys, pad';
  watch.watch(true, true);
  watch.reportAgain();
  watch.watch(true, true);
  expect(sent).toHaveLength(3);
});

it('devices are not reported while the sticks do not move the arm', () => {
  const { sent, watch } = station();
  watch.watch(true, false);
  watch.watch(false, false);
  expect(sent).toEqual([]);
});

it('a lost device is reported once, and its return is logged', () => {
  const { devices, sent, levels, watch } = station();
  devices.lost = [{ short: 'pad' }];
  watch.watch(true, false);
  watch.watch(true, false);
  expect(sent).toEqual(['hands_off']);
  devices.lost = [];
  watch.watch(true, false);
  expect(levels).toEqual(['caution', 'info']);
});

it('an observer’s lost device does not stop the operator', () => {
  const { devices, sent, levels, watch } = station();
  devices.lost = [{ short: 'pad' }];
  watch.watch(false, false);
  expect(sent).toEqual([]);
  expect(levels).toEqual(['caution']);
});

it('an axis that sends no number, always or now and then, is logged once until its device is lost', () => {
  const { devices, sent, levels, watch } = station();
  const fault = 'pad: Left stick ↕ sends no number';
  for (const faults of [[fault], [fault], [], [fault], []]) {
    devices.faults = faults;
    watch.watch(true, false);
  }
  expect([levels, sent]).toEqual([['caution'], []]);
  devices.lost = [{ short: 'pad' }];
  watch.watch(true, false);
  devices.lost = [];
  devices.faults = [fault];
  watch.watch(true, false);
  expect(levels).toEqual(['caution', 'caution', 'info', 'caution']);
});

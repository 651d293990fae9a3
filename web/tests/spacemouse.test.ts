import { expect, test, vi } from 'vitest';
import { isZero } from '../src/input/deflection';
import { Device } from '../src/input/device';
import { CAP_AT_REST, parsed, SpaceMouse } from '../src/input/spacemouse';

/** Returns a SpaceMouse that the page has permission to use, and functions that send its reports and unplug it. */
async function connected(vendorId = 0x256f, usage = 8) {
  const device = Object.assign(new EventTarget(), {
    vendorId,
    productName: 'Cap',
    opened: false,
    collections: [{ usagePage: 1, usage }],
    async open() {},
  });
  const hid = Object.assign(new EventTarget(), {
    getDevices: async () => [device],
    requestDevice: async () => [device],
  });
  vi.stubGlobal('navigator', { hid });
  const mouse = new SpaceMouse();
  await vi.waitFor(() => expect(mouse.name || vendorId !== 0x256f || usage !== 8).toBeTruthy());
  return {
    mouse,
    report(reportId: number, ...values: number[]) {
      const data = new DataView(new ArrayBuffer(2 * values.length));
      values.forEach((value, i) => {
        data.setInt16(2 * i, value, true);
      });
      device.dispatchEvent(Object.assign(new Event('inputreport'), { reportId, data }));
    },
    unplug() {
      hid.dispatchEvent(Object.assign(new Event('disconnect'), { device }));
    },
  };
}

test('a permitted SpaceMouse connects without a question and is lost when unplugged', async () => {
  const { mouse, report, unplug } = await connected();
  report(1, 0, -350, 0);
  expect(mouse.reading(0)?.axes).toEqual([0, -1, 0, 0, 0, 0]);
  unplug();
  expect(mouse.reading(10)).toBeNull();
});

test('a silent SpaceMouse is lost only while it is deflected', async () => {
  const { mouse, report } = await connected();
  for (let now = 0; now < 300; now += 20) mouse.reading(now);
  for (let now = 300; now < 5000; now += 20) expect(mouse.reading(now)).not.toBeNull();
  report(1, 0, 100, 0);
  let last = 5000;
  while (mouse.reading(last) && last < 10_000) last += 20;
  expect(last - 5000).toBeGreaterThanOrEqual(480);
  expect(last - 5000).toBeLessThanOrEqual(540);
  report(1, 0, 100, 0);
  expect(mouse.reading(last + 20)).not.toBeNull();
});

test('a SpaceMouse on which something leans when it is opened moves nothing until it was released', async () => {
  const { mouse, report } = await connected();
  const device = new Device('spacemouse', () => {});
  const flies = (now: number) => !isZero(device.read(mouse.reading(now), now));
  for (let now = 0; now < 100; now += 20) expect(flies(now)).toBe(false);
  for (let now = 100; now < 5000; now += 20) {
    report(1, 0, -350, 0);
    expect(flies(now)).toBe(false);
  }
  expect(device.state).toBe('waiting');
  report(1, 0, 0, 0);
  for (let now = 5000; now < 7000; now += 20) expect(flies(now)).toBe(false);
  report(1, 0, -350, 0);
  expect(flies(7000)).toBe(true);
});

test('a busy page does not lose a SpaceMouse', async () => {
  const { mouse, report } = await connected();
  report(1, 0, 100, 0);
  expect(mouse.reading(100)).not.toBeNull();
  expect(mouse.reading(5100)).not.toBeNull();
});

test('an invalid report is named and deflects nothing', async () => {
  const { mouse, report } = await connected();
  report(1, 1, 2);
  expect(mouse.problem).toContain('Report 1 with 4 bytes');
  expect(mouse.reading(0)).toBeNull();
});

test('a mouse of the same maker is not a SpaceMouse', async () => {
  const { mouse } = await connected(0x046d, 2);
  expect(mouse.reading(0)).toBeNull();
  expect(mouse.name).toBe('');
});

function reportData(...values: number[]): DataView {
  const data = new DataView(new ArrayBuffer(2 * values.length));
  values.forEach((value, i) => {
    data.setInt16(2 * i, value, true);
  });
  return data;
}

test('a SpaceMouse sends its axes in two reports or in one', () => {
  const two = parsed(CAP_AT_REST, 1, reportData(350, -175, 0));
  expect(two?.axes).toEqual([1, -0.5, 0, 0, 0, 0]);
  const turned = two && parsed(two, 2, reportData(0, 0, -350));
  expect(turned?.axes).toEqual([1, -0.5, 0, 0, 0, -1]);
  expect(parsed(CAP_AT_REST, 1, reportData(0, 0, 70, 0, 0, 700))?.axes).toEqual([0, 0, 0.2, 0, 0, 1]);
});

test('a report of a wrong length is invalid; an unknown report is ignored', () => {
  expect(parsed(CAP_AT_REST, 1, reportData(1, 2))).toBeNull();
  expect(parsed(CAP_AT_REST, 1, reportData(1, 2, 3, 4, 5))).toBeNull();
  expect(parsed(CAP_AT_REST, 2, new DataView(new ArrayBuffer(5)))).toBeNull();
  expect(parsed(CAP_AT_REST, 0x17, new DataView(new ArrayBuffer(1)))).toBe(CAP_AT_REST);
  const buttons = parsed(CAP_AT_REST, 3, new DataView(Uint8Array.of(2, 1).buffer))?.buttons;
  expect(buttons?.flatMap((down, i) => (down ? [i] : []))).toEqual([1, 8]);
});

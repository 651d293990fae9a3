import { expect, test, vi } from 'vitest';
import { SpaceMouse } from '../src/input/spacemouse';

/** A SpaceMouse that a test turns, allowed to this page before. */
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

test('one that was allowed before is there again, and gone when it is unplugged', async () => {
  const { mouse, report, unplug } = await connected();
  report(1, 0, -350, 0);
  expect(mouse.reading(0)?.axes).toEqual([0, -1, 0, 0, 0, 0]);
  unplug();
  expect(mouse.reading(10)).toBeNull();
});

test('deflected and silent it is out of reach; at rest it may be silent for ever', async () => {
  const { mouse, report } = await connected();
  for (let now = 0; now < 5000; now += 20) expect(mouse.reading(now)).not.toBeNull();
  report(1, 0, 100, 0);
  let last = 5000;
  while (mouse.reading(last) && last < 10_000) last += 20;
  expect(last - 5000).toBeGreaterThanOrEqual(480);
  expect(last - 5000).toBeLessThanOrEqual(540);
  report(1, 0, 100, 0);
  expect(mouse.reading(last + 20)).not.toBeNull();
});

test('a page that was busy for seconds takes nothing from it', async () => {
  const { mouse, report } = await connected();
  report(1, 0, 100, 0);
  expect(mouse.reading(100)).not.toBeNull();
  expect(mouse.reading(5100)).not.toBeNull();
});

test('a report that is not understood is said, and moves nothing', async () => {
  const { mouse, report } = await connected();
  report(1, 1, 2);
  expect(mouse.problem).toContain('Report 1 with 4 bytes');
  expect(mouse.reading(0)).toBeNull();
});

test('a mouse of the same makers is none', async () => {
  const { mouse } = await connected(0x046d, 2);
  expect(mouse.reading(0)).toBeNull();
  expect(mouse.name).toBe('');
});

import type { WebGLRenderer } from 'three';
import { afterEach, beforeEach, describe, expect, it, test, vi } from 'vitest';
import type { Lighting } from '../src/link/protocol';
import { LIGHT_OF } from '../src/scene/agx';
import type { Quality } from '../src/scene/drawn';
import { KEY, RANGE } from '../src/scene/exposure';
import { Exposures } from '../src/scene/exposures';

beforeEach(() => {
  vi.useFakeTimers();
});

afterEach(() => {
  vi.useRealTimers();
});

const PICTURE = { x: 0, y: 0, width: 400, height: 300 };
const NONE: Lighting['locked'] = [];

/** Exposures of the cameras A and B; every pixel of a picture has the byte `light`. */
function metering(quality: Quality = 'full') {
  const picture = { light: 128, ready: true };
  const nothing = () => {};
  const rows = vi.fn();
  const gl = {
    ...{ bindBuffer: nothing, bufferData: nothing, flush: nothing, deleteSync: nothing, readPixels: rows },
    TIMEOUT_EXPIRED: 1,
    isContextLost: () => false,
    createBuffer: () => ({}),
    fenceSync: () => ({}),
    clientWaitSync: () => (picture.ready ? 0 : 1),
    getBufferSubData: (_target: number, _offset: number, bytes: Uint8Array) => bytes.fill(picture.light),
  };
  const renderer = { getContext: () => gl } as unknown as WebGLRenderer;
  const exposures = new Exposures(['A', 'B'], renderer, quality);
  let time = 0;
  const follow = (locked = NONE, base = 0) => {
    time += 0.02;
    exposures.follow(time, base, locked);
  };
  /** Draws a picture; returns whether its metering starts. */
  const draw = (camera: string, factor = 1) => {
    const before = rows.mock.calls.length;
    exposures.measure(camera, PICTURE, factor);
    return rows.mock.calls.length > before;
  };
  /** Draws a picture, then collects its light by `follow`; returns whether its metering started. */
  const meter = (camera: string, factor = 1) => {
    const begun = draw(camera, factor);
    follow();
    return begun;
  };
  return { picture, exposures, follow, draw, meter };
}

describe('a camera', () => {
  it('is metering until the light of its picture is available', () => {
    const { picture, exposures, follow, draw } = metering();
    picture.ready = false;
    draw('A');
    follow();
    expect(exposures.metering('A')).toBe(true);
    picture.ready = true;
    follow();
    expect([exposures.metering('A'), exposures.metering('B')]).toEqual([false, true]);
  });

  it('has the exposure of the light condition before its first picture', () => {
    const { exposures, follow } = metering();
    expect(exposures.stops('A')).toBe(0);
    follow(NONE, 3);
    expect(exposures.stops('A')).toBe(3);
  });

  it('without a name in the scenario has no exposure', () => {
    const { exposures, draw, follow } = metering();
    follow(NONE, 3);
    expect(draw('none of them')).toBe(false);
    expect(exposures.stops('none of them')).toBe(0);
    expect(exposures.metering('none of them')).toBe(false);
  });
});

describe('an exposure', () => {
  const stops = (light: number, factor = 1, quality: Quality = 'full') => {
    const { picture, exposures, meter } = metering(quality);
    picture.light = light;
    meter('A', factor);
    return exposures.stops('A');
  };

  it.each<Quality>(['full', 'low'])('is smaller for a brighter picture, within its range: %s', (quality) => {
    const all = [250, 180, 120, 60, 20].map((light) => stops(light, 1, quality));
    expect([...all].sort((a, b) => a - b)).toEqual(all);
    expect(new Set(all).size).toBeGreaterThan(3);
    expect(Math.max(...all.map(Math.abs))).toBeLessThanOrEqual(RANGE);
  });

  it('brings the light of a picture to the value KEY, by the tone curve of the profile', () => {
    const light = { full: LIGHT_OF[180] ?? Number.NaN, low: (180 / 255) ** 2 };
    for (const quality of ['full', 'low'] as const)
      expect(stops(180, 1, quality)).toBeCloseTo(Math.log2(KEY / light[quality]), 1);
    expect(stops(180, 1, 'full')).not.toBeCloseTo(stops(180, 1, 'low'), 1);
  });

  it('is one stop larger if the picture was drawn with twice the light', () => {
    expect(stops(180, 2) - stops(180, 1)).toBeCloseTo(1, 1);
  });

  it('is a whole number of fiftieths of a stop', () => {
    for (const light of [90, 100, 110, 120, 130]) {
      const steps = 50 * stops(light);
      expect(steps).toBeCloseTo(Math.round(steps), 9);
    }
  });

  it('is fixed only for a locked camera', () => {
    const { exposures, follow, meter } = metering();
    meter('A');
    const before = exposures.stops('A');
    meter('B');
    follow([{ camera: 'B', stops: 1.5 }]);
    expect([exposures.stops('A'), exposures.stops('B')]).toEqual([before, 1.5]);
  });

  it('of a locked camera needs no picture', () => {
    const { exposures, follow } = metering();
    follow([{ camera: 'B', stops: 1.5 }]);
    expect([exposures.metering('A'), exposures.metering('B')]).toEqual([true, false]);
  });
});

test('only one picture is metered at a time', () => {
  const { follow, draw } = metering();
  expect([draw('A'), draw('B')]).toEqual([true, false]);
  follow();
  expect(draw('B')).toBe(true);
});

test('cameras without an exposure are metered at once', () => {
  const { meter } = metering();
  expect([meter('A'), meter('B')]).toEqual([true, true]);
});

test.each<[Quality, number]>([
  ['full', 300],
  ['low', 1500],
])(
  'meterings are at least one interval apart, those of the same camera two intervals: %s',
  (quality, interval) => {
    const { meter } = metering(quality);
    meter('A');
    vi.advanceTimersByTime(interval);
    meter('B');
    vi.advanceTimersByTime(interval - 1);
    expect([meter('A'), meter('B')]).toEqual([false, false]);
    vi.advanceTimersByTime(1);
    expect([meter('B'), meter('A')]).toEqual([false, true]);
    vi.advanceTimersByTime(1.5 * interval);
    expect(meter('B')).toBe(true);
    vi.advanceTimersByTime(0.75 * interval);
    expect(meter('A')).toBe(false);
    vi.advanceTimersByTime(0.25 * interval);
    expect(meter('A')).toBe(true);
  },
);

test('a picture of the previous light condition sets no exposure', () => {
  const { picture, exposures, draw, follow, meter } = metering();
  meter('A');
  const before = exposures.stops('A');
  vi.advanceTimersByTime(600);
  picture.light = 20;
  expect(draw('A')).toBe(true);
  exposures.renew();
  follow();
  expect(exposures.stops('A')).toBe(before);
  expect(exposures.metering('A')).toBe(true);
  expect(meter('A')).toBe(true);
  expect(exposures.stops('A')).toBeGreaterThan(before);
});

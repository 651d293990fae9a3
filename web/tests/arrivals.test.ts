import { describe, expect, it } from 'vitest';
import { Arrivals } from '../src/link/arrivals';
import { type Knows, ownLamps } from '../src/panel/spine/own-lamps';
import { link, sent } from './sent-frames';

describe('delays of frames', () => {
  it('are measured, except those of the first frame', () => {
    const arrivals = new Arrivals(link(1, 2, 0.5));
    expect(arrivals.silence(9000)).toBe(0);
    for (let step = 1; step < 60; step += 1) {
      const now = 100 * step + 30; // drawn 30 ms after its arrival
      arrivals.put(sent(step, [10, 20]), 100 * step);
      for (const shows of ['telemetry', 'camera'] as const) {
        const seen = arrivals.at(shows);
        if (seen) arrivals.show(shows, seen, now);
      }
    }
    const delays = arrivals.delays(0.7, 6000);
    expect(delays.command).toEqual({ set: 0.5, measured: 0.7 });
    expect(delays.telemetry.set).toBe(1);
    expect(delays.telemetry.measured).toBeCloseTo(1.03);
    expect(delays.camera.set).toBe(2);
    expect(delays.camera.measured).toBeCloseTo(2.03);
    expect(arrivals.silence(6900)).toBeCloseTo(1);
  });
});

describe('lamps of the page', () => {
  const none = { set: 0, measured: null };
  const well: Knows = {
    refusedAt: -Infinity,
    silence: 0.1,
    delays: { command: none, telemetry: none, camera: none },
    pictures: { s: 0.1, set: 0 },
    controllers: { lost: [], waiting: [] },
  };
  const lit = (knows: Partial<Knows>, now = 0) =>
    ownLamps({ ...well, ...knows }, now).map(({ name }) => name);

  it('are dark without a fault', () => {
    expect(lit({})).toEqual([]);
  });

  it('show a rejection for 5 s, a silent link and late pictures', () => {
    expect(lit({ refusedAt: 1000 }, 5999)).toEqual(['CHECK CRT']);
    expect(lit({ refusedAt: 1000 }, 6001)).toEqual([]);
    expect(lit({ silence: 0.6 })).toEqual(['LINK DELAY']);
    expect(lit({ pictures: { s: 2.4, set: 2 } })).toEqual([]);
    expect(lit({ pictures: { s: 2.6, set: 2 } })).toEqual(['CAMERA']);
  });
});

import { describe, expect, it } from 'vitest';
import { Arrivals } from '../src/link/delayed-messages';
import type { Frame, Event as LogEvent } from '../src/link/protocol';
import { type Knows, ownLamps } from '../src/panel/spine/own-lamps';

const DELAYS = { command_delay_s: 0.5, telemetry_delay_s: 1, camera_delay_s: 2 };
/** A frame every 100 ms. */
const frame = (tick: number) => ({ tick, time_s: tick / 10 }) as Frame;
const line = (time_s: number): LogEvent => ({ time_s, kind: 'mode', level: 'info', text: `at ${time_s}` });

describe('messages from the station', () => {
  it('are shown with the delays of the scenario', () => {
    const arrivals = new Arrivals(DELAYS);
    const shown: LogEvent[] = [];
    for (let tick = 0; tick < 60; tick += 1) {
      const now = 100 * tick;
      arrivals.put(frame(tick), now);
      arrivals.addEvents([line(tick / 10)]);
      expect(arrivals.at('telemetry', now)?.frame.tick).toBe(Math.max(0, tick - 10));
      expect(arrivals.at('camera', now)?.frame.tick).toBe(Math.max(0, tick - 20));
      shown.push(...arrivals.dueEvents(now));
      expect(shown.length).toBe(Math.max(0, tick - 10) + 1);
    }
    expect(shown).toEqual(Array.from({ length: 50 }, (_, tick) => line(tick / 10)));
  });

  it('keep all log lines at a restart', () => {
    const arrivals = new Arrivals(DELAYS);
    for (const tick of [50, 51, 52]) expect(arrivals.put(frame(tick), 100 * tick)).toBe(false);
    arrivals.addEvents([line(5.1), line(5.2)]);
    expect(arrivals.dueEvents(5200)).toEqual([]);
    expect(arrivals.put(frame(0), 5300)).toBe(true);
    expect(arrivals.restarts).toBe(1);
    expect(arrivals.takeEvents()).toEqual([line(5.1), line(5.2)]);
    expect(arrivals.takeEvents()).toEqual([]);
  });

  it('have a measured age, except the first one', () => {
    const arrivals = new Arrivals(DELAYS);
    expect(arrivals.silence(9000)).toBe(0);
    for (let tick = 0; tick < 60; tick += 1) {
      const now = 100 * tick + 30; // drawn 30 ms after its arrival
      arrivals.put(frame(tick), 100 * tick);
      for (const shows of ['telemetry', 'camera'] as const) {
        const seen = arrivals.at(shows, now);
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

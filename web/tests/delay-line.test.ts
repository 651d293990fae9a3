import { describe, expect, it } from 'vitest';
import { DelayLine, isStale } from '../src/link/delay-line';
import type { Frame } from '../src/link/protocol';

/** Returns the tick that a delay line with `delay` [s] shows at each time [ms]. Frames arrive at 0, 100, 200 … ms. */
function shows(delay: number, times: readonly number[], frames = 100): readonly (number | undefined)[] {
  const line = new DelayLine(delay);
  let tick = 0;
  return times.map((now) => {
    for (; tick < frames && 100 * tick <= now; tick += 1) line.put(seen(tick, 100 * tick));
    return line.at(now)?.frame.tick;
  });
}

const seen = (tick: number, at: number) => ({ frame: { tick } as Frame, at });

describe('a delay line', () => {
  it('shows each frame after the delay, in order', () => {
    const times = Array.from({ length: 500 }, (_, i) => 7 * i);
    shows(1.5, times).forEach((tick, i) => {
      expect(tick).toBe(Math.max(0, Math.floor(((times[i] ?? 0) - 1500) / 100)));
    });
  });

  it('shows the newest frame if the delay is zero', () => {
    expect(shows(0, [0, 99, 100, 250])).toEqual([0, 0, 1, 2]);
    const line = new DelayLine(0);
    line.put(seen(0, 500)); // arrived just before the page drew an earlier frame
    expect(line.at(499)?.frame.tick).toBe(0);
  });

  it('shows nothing before the first frame', () => {
    expect(new DelayLine(1).at(5000)).toBeNull();
    expect(new DelayLine(1).age(5000)).toEqual({ s: 0, set: 1, undrawn: false });
  });

  it('discards pending frames at a restart', () => {
    const line = new DelayLine(2);
    for (let tick = 0; tick < 50; tick += 1) line.put(seen(tick, 100 * tick));
    expect(line.at(4900)?.frame.tick).toBe(29);
    line.put(seen(0, 5000));
    expect(line.at(5000)?.frame.tick).toBe(0);
    line.put(seen(1, 5100));
    expect(line.at(7000)?.frame.tick).toBe(0);
    expect(line.at(7100)?.frame.tick).toBe(1);
  });

  it('is stale if no new frame arrives until 0.5 s after its delay', () => {
    const line = new DelayLine(2);
    for (let tick = 0; tick < 10; tick += 1) line.put(seen(tick, 100 * tick));
    const stale = (now: number) => {
      line.displayed(now);
      return isStale(line.age(now));
    };
    expect([0, 900, 2900, 900 + 2400, 900 + 2600].map(stale)).toEqual([false, false, false, false, true]);
    expect(line.age(900 + 2600).undrawn).toBe(false);
  });
});

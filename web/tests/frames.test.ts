import { describe, expect, it } from 'vitest';
import { Displayed, isStale } from '../src/link/age';
import { Frames, type Shows } from '../src/link/frames';
import type { Frame } from '../src/link/protocol';
import { PERIOD_S, sent } from './sent-frames';

/** Delays of telemetry and pictures [steps]. */
const LATE = [10, 20] as const;

const step = (frames: Frames, shows: Shows) => frames.at(shows)?.step;

/** Numbers from `first` to `last`. */
const from = (first: number, last: number) => Array.from({ length: last - first + 1 }, (_, i) => first + i);

describe('the frames of a page', () => {
  it('show the steps that the newest frame names, and the first one before', () => {
    const frames = new Frames(PERIOD_S);
    expect(frames.at('camera')).toBeNull();
    for (const n of from(1, 60)) {
      frames.put(sent(n, LATE), 100 * n);
      expect(step(frames, 'telemetry')).toBe(Math.max(1, n - 10));
      expect(step(frames, 'camera')).toBe(Math.max(1, n - 20));
    }
  });

  it('show the newest frame without a delay, and keep no other', () => {
    const frames = new Frames(PERIOD_S);
    for (const n of from(1, 60)) {
      frames.put(sent(n), 100 * n);
      expect([step(frames, 'telemetry'), step(frames, 'camera'), frames.late('camera')]).toEqual([n, n, 0]);
    }
    frames.put({ ...sent(61), display: { link: { ...sent(61).display.link, pictures: 1 } } } as Frame, 6100);
    expect(step(frames, 'camera')).toBe(60); // the page has dropped all frames before
  });

  it('show the newest frame before a step that was skipped for the page', () => {
    const frames = new Frames(PERIOD_S);
    for (const n of [3, 7, 8, 15, 19, 27, 33]) frames.put(sent(n, LATE), 100 * n);
    expect([step(frames, 'telemetry'), step(frames, 'camera')]).toEqual([19, 8]);
    expect(frames.late('camera')).toBeCloseTo(2);
    expect(frames.behind(frames.at('camera') ?? expect.fail())).toBeCloseTo(2.5);
  });

  it('show a restart after the delay', () => {
    const frames = new Frames(PERIOD_S);
    const begins = from(1, 60).filter((n) => frames.put(sent(n, LATE, n > 40 ? 40 : 0), 100 * n));
    expect(begins).toEqual([41]);
    expect(frames.newest).toMatchObject({ frame: { tick: 20 }, restarts: 1 });
    expect(frames.at('telemetry')).toMatchObject({ frame: { tick: 10 }, restarts: 1 });
    expect(frames.at('camera')).toMatchObject({ frame: { tick: 40 }, restarts: 0 });
    frames.put(sent(61, LATE, 40), 6100);
    expect(frames.at('camera')).toMatchObject({ frame: { tick: 1 }, restarts: 1 });
  });

  it('notice a restart of which they received no early frame', () => {
    const frames = new Frames(PERIOD_S);
    frames.put(sent(10), 1000);
    expect(frames.put(sent(40, [0, 0], 15), 4000)).toBe(true);
    expect(frames.newest).toMatchObject({ frame: { tick: 25 }, restarts: 1 });
  });

  it('begin again in another session', () => {
    const frames = new Frames(PERIOD_S);
    for (const n of from(1, 60)) frames.put(sent(n, LATE), 100 * n);
    expect(frames.put(sent(1, LATE), 6100)).toBe(true);
    expect([step(frames, 'telemetry'), step(frames, 'camera')]).toEqual([1, 1]);
  });

  it('show another step in the pictures of cameras with a delay of their own', () => {
    const frames = new Frames(PERIOD_S);
    const late = (n: number, cameras: readonly [string, number][]) => {
      const frame = sent(n, LATE);
      const named = cameras.map(([name, delay]) => [name, n - delay] as const);
      return {
        ...frame,
        display: { ...frame.display, link: { ...frame.display.link, cameras: named } },
      } as Frame;
    };
    for (const n of from(1, 60))
      frames.put(
        late(n, [
          ['A', 5],
          ['B', 30],
        ]),
        100 * n,
      );
    const ticks = (...names: string[]) => names.map((name) => frames.pictures?.of(name).tick);
    expect(ticks('A', 'B', 'C')).toEqual([55, 30, 40]);
    expect(frames.late('camera', 'B')).toBeCloseTo(3);
    expect(new Displayed(frames, 'camera').age(6000, true, 'A').set).toBeCloseTo(0.5);
    frames.put(late(61, []), 6100);
    expect([frames.pictures?.differ, ...ticks('A', 'B')]).toEqual([false, 41, 41]);
  });

  it('of a recording show the playhead, which may move back', () => {
    const frames = new Frames(PERIOD_S);
    const recorded = (tick: number) => ({ tick, display: { link: null } }) as Frame;
    for (const tick of [50, 51, 3, 3, 4]) {
      frames.put(recorded(tick), 0);
      expect([step(frames, 'telemetry'), step(frames, 'camera')]).toEqual([tick, tick]);
    }
  });
});

describe('the age of what is displayed', () => {
  it('is zero before the first frame', () => {
    expect(new Displayed(new Frames(PERIOD_S), 'camera').age(5000)).toEqual({ s: 0, set: 0, undrawn: false });
  });

  it('is that of the first frame until the link has let it through, and then the delay', () => {
    const frames = new Frames(PERIOD_S);
    const pictures = new Displayed(frames, 'camera');
    const ages = from(1, 40).map((n) => {
      frames.put(sent(n, LATE), 100 * n);
      pictures.displayed(100 * n);
      return pictures.age(100 * n);
    });
    for (const [i, { s, set }] of ages.entries()) {
      expect(s).toBeCloseTo(Math.min(2, PERIOD_S * i));
      expect(set).toBeCloseTo(Math.min(2, PERIOD_S * i));
    }
  });

  it('is stale 0.5 s after the last frame has arrived', () => {
    const frames = new Frames(PERIOD_S);
    const pictures = new Displayed(frames, 'camera');
    for (const n of from(1, 40)) frames.put(sent(n, LATE), 100 * n);
    const stale = (now: number) => {
      pictures.displayed(now);
      return isStale(pictures.age(now));
    };
    expect([4000, 4400, 4600].map(stale)).toEqual([false, false, true]);
    expect(pictures.age(4600).undrawn).toBe(false);
  });
});

import { describe, expect, it } from 'vitest';
import { Latency } from '../src/latency';
import { delayWords, linkLamp } from '../src/panel/link';

describe('stick to picture', () => {
  it('lasts from the input to the first picture that shows it', () => {
    const latency = new Latency();
    latency.sent(7, 100);
    latency.drawn(6, 130);
    expect(latency.percentile95(130)).toBeNull();
    latency.drawn(8, 160);
    latency.drawn(9, 500);
    expect(latency.percentile95(160)).toBe(60);
    expect(latency.percentile95(160 + 10_001)).toBeNull();
  });

  it('tells what of it is the link’s, by the frame’s arrival', () => {
    const latency = new Latency();
    latency.sent(1, 100);
    latency.sent(2, 200);
    latency.answered(1, 600);
    latency.answered(3, 720);
    expect(latency.answer(800)).toBe(0.5);
    expect(latency.answer(720 + 10_001)).toBeNull();
    expect(latency.percentile95(800)).toBeNull();
  });

  it('the rail tells the delay that is set, and the measured one where they differ', () => {
    expect(delayWords(0, null)).toBe('');
    expect(delayWords(0, 0.09)).toBe('');
    expect(delayWords(0, 0.31)).toBe('set 0.00, measured 0.31 s');
    expect(delayWords(2, null)).toBe('2.00 s');
    expect(delayWords(2, 2.09)).toBe('2.00 s');
    expect(delayWords(2, 2.31)).toBe('set 2.00, measured 2.31 s');
    expect(delayWords(2, 1.5)).toBe('set 2.00, measured 1.50 s');
  });

  it('LINK DELAY tells of a delay in force, of a longer one and of silence', () => {
    expect(linkLamp(0.1, 0, 0.05)).toBeNull();
    expect(linkLamp(0.1, 0, null)).toBeNull();
    expect(linkLamp(0.1, 0.5, 0.55)).toMatchObject({ level: 'info', text: 'commands take 0.50 s' });
    expect(linkLamp(0.1, 0.5, 0.9)).toMatchObject({
      level: 'caution',
      text: 'commands take 0.90 s, 0.50 s set',
    });
    expect(linkLamp(3.2, 0.5, 0.55)).toMatchObject({ level: 'caution', text: 'silent for 3 s' });
  });

  it('lets no picture be begun without an input that is about to be answered', () => {
    const latency = new Latency();
    expect(latency.due(0, 0)).toBe(false);
    latency.sent(7, 100);
    expect(latency.due(6, 110)).toBe(true);
    expect(latency.due(6, 120)).toBe(true);
    expect(latency.due(7, 121)).toBe(false); // the frame at hand has flown it
  });

  it('waits no longer than a station takes that is well', () => {
    const latency = new Latency();
    latency.sent(7, 100);
    expect(latency.due(6, 139)).toBe(true);
    expect(latency.due(6, 140)).toBe(false);
  });

  it('holds no picture up for each of many inputs', () => {
    const latency = new Latency();
    let held = 0;
    // A stick that is moved on and on: a message every 15 ms, answered 20 ms later.
    for (let now = 0, seq = 0; now < 3000; now += 5) {
      if (now % 15 === 0) latency.sent(++seq, now);
      const flown = Math.floor((now - 20) / 15) + 1;
      if (latency.due(flown, now)) held += 5;
      else latency.drawn(flown, now);
    }
    expect(held).toBeGreaterThan(0);
    expect(held).toBeLessThan(0.3 * 3000);
  });
});

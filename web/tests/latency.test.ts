import { describe, expect, it, test } from 'vitest';
import { Latency } from '../src/link/latency';
import { type Delay, type Delays, delayWords, linkLamp } from '../src/panel/rail/delays';

const NONE: Delay = { set: 0, measured: null };
const delays = (command: Delay, others: Partial<Delays> = {}): Delays => ({
  command,
  telemetry: NONE,
  camera: NONE,
  ...others,
});

describe('stick to picture', () => {
  it('is the time from the input to the first picture that shows it', () => {
    const latency = new Latency();
    latency.sent(7, 100);
    latency.drawn(6, 130);
    expect(latency.percentile95(130)).toBeNull();
    latency.drawn(8, 160);
    latency.drawn(9, 500);
    expect(latency.percentile95(160)).toBe(60);
    expect(latency.percentile95(160 + 10_001)).toBeNull();
  });

  it('is measured separately from the time until the first frame that used the input arrives', () => {
    const latency = new Latency();
    latency.sent(1, 100);
    latency.sent(2, 200);
    latency.answered(1, 600);
    latency.answered(3, 720);
    expect(latency.answer(800)).toBe(0.5);
    expect(latency.answer(720 + 10_001)).toBeNull();
    expect(latency.percentile95(800)).toBeNull();
  });

  it('excludes the delay that the link gave the picture', () => {
    const latency = new Latency();
    latency.sent(1, 100);
    latency.drawn(1, 2160, 2);
    expect(latency.percentile95(2160)).toBe(60);
  });

  it('the rail shows the set delay, and also the measured delay if it differs', () => {
    const delayText = (set: number, measured: number | null) => {
      const { label, text } = delayWords(delays({ set, measured }));
      return `${label} ${text}`;
    };
    expect(delayText(0, null)).toBe('Delay ');
    expect(delayText(0, 0.09)).toBe('Delay ');
    expect(delayText(0, 0.31)).toBe('Command set 0.00, measured 0.31 s');
    expect(delayText(2, null)).toBe('Command delay 2.00 s');
    expect(delayText(2, 2.09)).toBe('Command delay 2.00 s');
    expect(delayText(2, 2.31)).toBe('Command set 2.00, measured 2.31 s');
    expect(delayText(2, 1.5)).toBe('Command set 2.00, measured 1.50 s');
  });

  it('the rail shows only delays that are set', () => {
    const camera = { set: 1.5, measured: 1.52 };
    const telemetry = { set: 1, measured: 1.31 };
    expect(delayWords(delays(NONE, { camera }))).toEqual({ label: 'Camera delay', text: '1.50 s' });
    expect(delayWords(delays(NONE, { telemetry }))).toEqual({
      label: 'Telemetry',
      text: 'set 1.00, measured 1.31 s',
    });
    expect(delayWords(delays({ set: 2, measured: null }, { telemetry, camera }))).toEqual({
      label: 'Delay',
      text: 'CMD 2.00 · TLM 1.00 (1.31) · CAM 1.50 s',
    });
  });

  it('LINK DELAY shows an active delay, a longer one and a silent link', () => {
    const lamp = (silence: number, set: number, measured: number | null) =>
      linkLamp(silence, delays({ set, measured }));
    expect(lamp(0.1, 0, 0.05)).toBeNull();
    expect(lamp(0.1, 0, null)).toBeNull();
    expect(lamp(0.1, 0.5, 0.55)).toMatchObject({ level: 'info', text: 'commands take 0.50 s' });
    expect(lamp(0.1, 0.5, 0.9)).toMatchObject({
      level: 'caution',
      text: 'commands take 0.90 s, 0.50 s set',
    });
    expect(lamp(3.2, 0.5, 0.55)).toMatchObject({ level: 'caution', text: 'silent for 3 s' });
    const old = { set: 1, measured: null };
    expect(linkLamp(0.1, delays(NONE, { telemetry: old, camera: old }))).toMatchObject({
      level: 'info',
      text: 'figures are 1.00 s old, pictures are 1.00 s old',
    });
  });

  it('postpones a picture for an input whose answer is due', () => {
    const latency = new Latency();
    expect(latency.due(0, 0)).toBe(false);
    latency.sent(7, 100);
    expect(latency.due(6, 110)).toBe(true);
    expect(latency.due(6, 120)).toBe(true);
    expect(latency.due(7, 121)).toBe(false); // this frame contains the input
  });

  it('waits only for the usual answer time of a station', () => {
    const latency = new Latency();
    latency.sent(7, 100);
    expect(latency.due(6, 139)).toBe(true);
    expect(latency.due(6, 140)).toBe(false);
  });

  it('does not postpone pictures again for each of many inputs', () => {
    const latency = new Latency();
    let held = 0;
    // A stick that moves continuously: one message every 15 ms, answered 20 ms later.
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

test('latency is the 95th percentile of the last 10 s', () => {
  const latency = new Latency();
  for (let i = 1; i <= 100; i += 1) {
    latency.sent(i, 0);
    latency.drawn(i, i);
  }
  expect(latency.percentile95(100)).toBe(95);
});

test('a lost connection discards the pending inputs', () => {
  const latency = new Latency();
  latency.sent(1, 0);
  latency.forget();
  latency.drawn(1, 50);
  expect(latency.percentile95(50)).toBeNull();
  latency.answered(1, 50);
  expect(latency.answer(50)).toBeNull();
});

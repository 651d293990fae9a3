import { describe, expect, it } from 'vitest';
import { kept, Tones } from '../src/page/tones';
import { FakeAudio } from './fake-audio';

function made(text: string | null = null) {
  const audio = new FakeAudio();
  const store = new Map<string, string>(text === null ? [] : [['aftdeck.tones', text]]);
  const kept = {
    getItem: (key: string) => store.get(key) ?? null,
    setItem: (key: string, value: string) => void store.set(key, value),
  };
  const tones = new Tones(kept, () => audio as unknown as AudioContext);
  return { audio, tones, store };
}

describe('tones', () => {
  it('are silent before the first key or pointer input', () => {
    const { audio, tones } = made();
    tones.sound('warning', true);
    tones.captured();
    expect(audio.tones).toHaveLength(0);
  });

  it('sound once for each new caution', () => {
    const { audio, tones } = made();
    tones.wake();
    tones.sound('caution', true);
    tones.sound('caution', false);
    tones.sound('caution', false);
    expect(audio.tones.map(({ frequency }) => frequency.value)).toEqual([500]);
    expect(audio.tones[0]?.ended).toBeCloseTo(0.25);
    tones.sound('caution', true);
    expect(audio.tones).toHaveLength(2);
    tones.sound('none', false);
    tones.sound('caution', false);
    expect(audio.tones).toHaveLength(3);
  });

  it('alternate between two pitches for a warning until acknowledged', () => {
    const { audio, tones } = made();
    tones.wake();
    const heard: number[] = [];
    for (let k = 0; k < 20; k++) {
      audio.currentTime = 0.05 + k / 10;
      tones.sound('warning', false);
      heard.push(audio.tones[0]?.frequency.value ?? 0);
    }
    expect(audio.tones).toHaveLength(1);
    const turns = heard.slice(1).filter((pitch, k) => pitch !== heard[k]).length;
    expect(turns).toBe(9);
    expect(new Set(heard)).toEqual(new Set([375, 1000]));
    tones.sound('none', false);
    expect(audio.tones[0]?.ended).not.toBeNull();
  });

  it('sound two rising clicks for a capture, and one click for a mode', () => {
    const { audio, tones } = made();
    tones.wake();
    tones.captured();
    const [one, two] = audio.tones;
    expect(two?.frequency.value).toBeGreaterThan(one?.frequency.value ?? Number.NaN);
    expect(two?.began).toBeGreaterThan(one?.ended ?? Number.NaN);
    tones.entered();
    expect(audio.tones).toHaveLength(3);
  });

  it('store volume and mute, which act at once', () => {
    const { audio, tones, store } = made();
    tones.wake();
    tones.set({ volume: 1 });
    const loud = audio.gain.gain.value;
    expect(loud).toBeGreaterThan(0);
    tones.set({ muted: true });
    expect(audio.gain.gain.value).toBe(0);
    const again = made(store.get('aftdeck.tones') ?? null);
    expect(again.tones.muted).toBe(true);
    expect(again.tones.volume).toBe(1);
    again.tones.set({ muted: false });
    again.tones.wake();
    expect(again.audio.gain.gain.value).toBeCloseTo(loud);
  });

  it.each(['', '{', '{"volume": 3, "muted": true}', '{"volume": "loud"}', 'null', '[]'])(
    'use the defaults if the stored settings are invalid: %s',
    (text) => {
      expect(kept(text)).toEqual({ volume: 0.5, muted: false });
    },
  );
});

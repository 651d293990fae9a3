import { expect, test } from 'vitest';
import type { Frame } from '../src/link/protocol';
import { Sounds } from '../src/page/sounds';
import { type Alarm, Tones } from '../src/page/tones';
import type { Spine } from '../src/panel/spine/spine';
import { FakeAudio } from './fake-audio';

/** The sounds of a page whose frames and alarms a test sets. */
function page() {
  const audio = new FakeAudio();
  const tones = new Tones({ getItem: () => null, setItem: () => true }, () => audio as never);
  tones.wake();
  let alarm: Alarm = 'none';
  const spine = { takeAlarm: () => ({ alarm, more: false }), setMuted() {} };
  const sounds = new Sounds(tones, spine as unknown as Spine);
  const rest = {
    mode: 'ORB UNL',
    rates: [0, 0, 0, 0, 0, 0],
    rate_limits: [0.04, 0.04, 0.04, 0.04, 0.04, 0.04],
    motions: [] as object[],
    work: { cargo: [{ held: false }] },
  };
  return {
    audio,
    tones,
    /** Shows a frame at rest with changes; returns the pitches of the new tones. */
    show(changes: Partial<typeof rest> = {}, now: Alarm = 'none') {
      const before = audio.tones.length;
      alarm = now;
      sounds.update({ ...rest, ...changes } as unknown as Frame);
      return audio.tones.slice(before).map(({ frequency }) => frequency.value);
    },
  };
}

test('modes, captures and alarms are heard at their events', () => {
  const { show } = page();
  expect(show()).toEqual([]);
  expect(show({ mode: 'SINGLE' })).toEqual([1200]);
  expect(show({ mode: 'SINGLE', work: { cargo: [{ held: true }] } })).toEqual([900, 1500]);
  expect(show({ mode: 'SINGLE', work: { cargo: [{ held: true }] } })).toEqual([]);
  expect(show({ mode: 'SINGLE' }, 'caution')).toEqual([500]);
  expect(show({ mode: 'SINGLE' }, 'warning')).toHaveLength(1);
});

test('motors are heard from their rates: faster joints are louder and higher', () => {
  const { audio, show } = page();
  const motors = () => [audio.gains[1]?.gain.value ?? 0, audio.oscillators[0]?.frequency.value ?? 0] as const;
  show();
  expect(motors()[0]).toBe(0);
  show({ rates: [0, -0.01, 0, 0, 0, 0] });
  const slow = motors();
  show({ rates: [0, -0.01, 0, 0, 0.04, 0] });
  const fast = motors();
  expect(slow[0]).toBeGreaterThan(0);
  expect(fast[0]).toBeGreaterThan(slow[0]);
  expect(fast[1]).toBeGreaterThan(slow[1]);
  expect(audio.gains[1]?.gain.later, 'they end if the page shows no more frames').toBe(0);
});

test('latches and snares are heard while they move', () => {
  const { audio, show } = page();
  const heard = () => (audio.gains[2]?.gain.value ?? 0) > 0;
  show();
  expect(heard()).toBe(false);
  show({ motions: [{ text: 'latches close', remaining_s: 12 }] });
  expect(heard()).toBe(true);
  show();
  expect(heard()).toBe(false);
});

test('one key switches all sounds off', () => {
  const { audio, tones } = page();
  expect(audio.gains[0]?.gain.value).toBeGreaterThan(0);
  tones.set({ muted: true });
  expect(audio.gains[0]?.gain.value).toBe(0);
});

/** Generates the station's sounds: tones for alarms, clicks for modes and captures, soft sounds of motors and latches. */

import { Hum } from './hum';
import type { Keeper } from './local-storage';

export type Alarm = 'none' | 'caution' | 'warning';

/** Caution: one tone. Pitch [Hz] and duration [s]. */
const CAUTION = { pitch: 500, seconds: 0.25 };
/** Warning: two alternating tones until it is acknowledged. Pitches [Hz], and duration of each tone (`half`) [s]. */
const WARNING = { pitches: [375, 1000], half: 0.2 } as const;
/** Clicks: duration, time between the starts of two clicks [s]; pitches for an entered mode and a capture [Hz]. */
const CLICK = { seconds: 0.03, apart: 0.11, entered: [1200], captured: [900, 1500] } as const;
/** Motors of the joints: pitch at rest and at the rate limit [Hz], gain at the rate limit. */
const MOTORS = { rest: 90, limit: 180, gain: 0.25 } as const;
/** A smaller fraction of the rate limit is silent. */
const STILL = 0.01;
/** Latches, snares and other mechanisms: pitch [Hz], gain. */
const MECHANISM = { pitch: 240, gain: 0.12 } as const;
/** Gain at full volume, 0 to 1. */
const LOUD = 0.25;
const KEPT = 'aftdeck.tones';

export interface Kept {
  readonly volume: number;
  readonly muted: boolean;
}

/** Returns the stored settings, or the defaults if `text` cannot be decoded. */
export function kept(text: string | null): Kept {
  const fresh = { volume: 0.5, muted: false };
  if (text === null) return fresh;
  try {
    const { volume, muted } = JSON.parse(text) as Partial<Kept>;
    if (typeof volume !== 'number' || !(volume >= 0 && volume <= 1) || typeof muted !== 'boolean')
      return fresh;
    return { volume, muted };
  } catch {
    return fresh;
  }
}

export class Tones {
  private context: AudioContext | null = null;
  private master: GainNode | null = null;
  private warble: OscillatorNode | null = null;
  private motors: Hum | null = null;
  private mechanism: Hum | null = null;
  private alarm: Alarm = 'none';
  private settings: Kept;

  /** `open` makes the audio context. Browsers allow its sound only after the first key or click. */
  constructor(
    private readonly store: Keeper,
    private readonly open: () => AudioContext,
  ) {
    this.settings = kept(store.getItem(KEPT));
  }

  get muted(): boolean {
    return this.settings.muted;
  }

  get volume(): number {
    return this.settings.volume;
  }

  set(change: Partial<Kept>): void {
    this.settings = { ...this.settings, ...change };
    this.store.setItem(KEPT, JSON.stringify(this.settings));
    if (this.master) this.master.gain.value = this.level;
  }

  /** Lets the browser play sounds; called at each key and each press of a pointer. */
  wake(): void {
    if (this.context) {
      if (this.context.state === 'suspended') void this.context.resume();
      return;
    }
    this.context = this.open();
    this.master = this.context.createGain();
    this.master.gain.value = this.level;
    this.master.connect(this.context.destination);
    this.motors = new Hum(this.context, this.master, 'triangle', MOTORS.gain);
    this.mechanism = new Hum(this.context, this.master, 'sawtooth', MECHANISM.gain);
  }

  /** Sounds the unacknowledged alarm; called ten times a second. `more`: an alarm was added since the last call. */
  sound(alarm: Alarm, more: boolean): void {
    if (alarm === 'caution' && (this.alarm === 'none' || more)) this.tone(CAUTION.pitch, 0, CAUTION.seconds);
    this.alarm = alarm;
    if (alarm !== 'warning') {
      this.warble?.stop();
      this.warble = null;
      return;
    }
    const { context, master } = this;
    if (!context || !master) return;
    if (!this.warble) {
      this.warble = context.createOscillator();
      this.warble.connect(master);
      this.warble.start();
    }
    this.warble.frequency.value = WARNING.pitches[Math.floor(context.currentTime / WARNING.half) % 2] ?? 0;
  }

  /**
   * Sounds motors and mechanisms; called ten times a second.
   *
   * @param rate greatest joint rate as a fraction of its limit.
   * @param mechanism whether a latch, the snares or another mechanism moves.
   */
  moving(rate: number, mechanism: boolean): void {
    const part = Math.min(1, rate);
    this.motors?.set(part < STILL ? 0 : part, MOTORS.rest + part * (MOTORS.limit - MOTORS.rest));
    this.mechanism?.set(Number(mechanism), MECHANISM.pitch);
  }

  /** Sounds the click for a captured payload. */
  captured(): void {
    CLICK.captured.forEach((pitch, k) => {
      this.tone(pitch, k * CLICK.apart, CLICK.seconds);
    });
  }

  /** Sounds the click for an entered mode. */
  entered(): void {
    this.tone(CLICK.entered[0], 0, CLICK.seconds);
  }

  dispose(): void {
    void this.context?.close();
    this.context = this.master = this.warble = this.motors = this.mechanism = null;
  }

  private get level(): number {
    return this.settings.muted ? 0 : this.settings.volume * LOUD;
  }

  private tone(pitch: number, after: number, seconds: number): void {
    const { context, master } = this;
    if (!context || !master) return;
    const tone = context.createOscillator();
    tone.frequency.value = pitch;
    tone.connect(master);
    tone.start(context.currentTime + after);
    tone.stop(context.currentTime + after + seconds);
  }
}

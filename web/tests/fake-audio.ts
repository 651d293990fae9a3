/** A fake graph of audio nodes that records what a listener would hear. */

type FakeParam = ReturnType<typeof param>;

/** A parameter of an audio node; `value` is the value that it approaches now, `later` the value after a pause. */
function param() {
  return {
    value: -1,
    later: Number.NaN,
    cancelScheduledValues() {},
    setTargetAtTime(value: number, at: number) {
      if (at > 0.4) this.later = value;
      else this.value = value;
    },
  };
}

/** An audio context that records the pitch, start and end of each oscillator. */
export class FakeAudio {
  currentTime = 0;
  state = 'running';
  destination = {};
  /** The master gain, then the gains of motors and mechanisms, each with its next value. */
  readonly gains: { gain: FakeParam; connect: () => void }[] = [];
  get gain() {
    return this.gains[0] ?? { gain: param() };
  }
  readonly oscillators: { frequency: FakeParam; began: number; ended: number | null }[] = [];
  /** The oscillators of tones and clicks, without those of motors and mechanisms. */
  get tones() {
    return this.oscillators.slice(2);
  }
  createGain = () => {
    const node = { gain: param(), connect: () => {} };
    this.gains.push(node);
    return node;
  };
  createOscillator = () => {
    const tone = {
      frequency: param(),
      began: Number.NaN,
      ended: null as number | null,
      connect: () => {},
      start: (at?: number) => {
        tone.began = at ?? this.currentTime;
      },
      stop: (at?: number) => {
        tone.ended = at ?? this.currentTime;
      },
    };
    this.oscillators.push(tone);
    return tone;
  };
  close = async () => {};
  resume = async () => {};
}

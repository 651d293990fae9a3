/** A soft, steady sound of something that moves. It ends by itself if it is not renewed. */

/** Time constant of changes, and time after which the sound ends if `set` is not called again [s]. */
const SMOOTH_S = 0.05;
const RENEWED_S = 0.5;

export class Hum {
  private readonly gain: GainNode;
  private readonly tone: OscillatorNode;

  /** `out`: node to which the sound is sent; `loudest`: gain at level 1. */
  constructor(
    private readonly context: AudioContext,
    out: AudioNode,
    type: OscillatorType,
    private readonly loudest: number,
  ) {
    this.gain = context.createGain();
    this.gain.gain.value = 0;
    this.gain.connect(out);
    this.tone = context.createOscillator();
    this.tone.type = type;
    this.tone.connect(this.gain);
    this.tone.start();
  }

  /** Sets the level, 0 to 1, and the pitch [Hz]; called ten times a second. */
  set(level: number, pitch: number): void {
    const now = this.context.currentTime;
    this.tone.frequency.setTargetAtTime(pitch, now, SMOOTH_S);
    this.gain.gain.cancelScheduledValues(now);
    this.gain.gain.setTargetAtTime(level * this.loudest, now, SMOOTH_S);
    // A hidden page draws no pictures, and does not call this function.
    this.gain.gain.setTargetAtTime(0, now + RENEWED_S, SMOOTH_S);
  }
}

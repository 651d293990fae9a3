/** Automatic exposure of a camera from its picture. All exposures are in stops over that of full sunlight. */

/** Greatest difference from the exposure at which the light condition begins [stops]. */
export const RANGE = 2;
/** Time in which the exposure's error decreases by the factor e [s]. */
export const TIME_CONSTANT_S = 0.8;
/** Light for which 0 stops is the right exposure: four tenths of the light from a white blanket in sunlight. */
export const KEY = 0.4;
/** Pause after which the exposure changes at once, as after a jump back in time [s]. */
const PAUSE_S = 2;

/**
 * Exposure that brings a picture's mean light to `KEY`. Each sample is weighted with itself, so that black space does not
 * count. Null if the picture is black.
 */
export function metered(lights: Iterable<number>): number | null {
  let [sum, squares] = [0, 0];
  for (const light of lights) {
    sum += light;
    squares += light * light;
  }
  return squares > 0 ? Math.log2((KEY * sum) / squares) : null;
}

/** One camera's exposure. */
export class Exposure {
  private now: number | null = null;
  /** Whether the next picture sets the exposure at once, not gradually. */
  private anew = true;
  private wanted: number | null = null;
  private at = 0;
  private base = 0;

  /** The present exposure. */
  get stops(): number {
    return this.now ?? this.base;
  }

  /** Whether the exposure was set from a picture. */
  get settled(): boolean {
    return !this.anew;
  }

  /** Lets the next picture set the exposure at once, because the light has changed. */
  renew(): void {
    this.anew = true;
  }

  /** Changes the exposure until a time [s]; `base`: exposure at which the light condition begins; `locked`: fixed exposure or null. */
  follow(time: number, base: number, locked: number | null): void {
    const step = time - this.at;
    this.at = time;
    this.base = base;
    if (step < 0 || step > PAUSE_S) this.anew = true;
    if (locked !== null) {
      this.now = locked;
      this.anew = false;
    } else if (this.now !== null && this.wanted !== null) {
      const aim = this.held(this.wanted);
      this.now = aim + (this.now - aim) * Math.exp(-Math.max(0, step) / TIME_CONSTANT_S);
    }
  }

  /** Takes the exposure that its picture needs; sets it at once the first time. */
  meter(wanted: number | null): void {
    if (wanted !== null) this.wanted = wanted;
    if (this.anew) this.now = this.held(wanted ?? this.base);
    this.anew = false;
  }

  private held(stops: number): number {
    return Math.min(this.base + RANGE, Math.max(this.base - RANGE, stops));
  }
}

/** How a camera's exposure follows its picture. All exposures are in stops over that of full sunlight. */

/** It goes this far from where the light's condition begins [stops]. */
export const RANGE = 2;
/** It comes nearer by e in this time [s]. */
export const TIME_CONSTANT_S = 0.8;
/** Light that is exposed right at 0 stops: four tenths of what a white blanket in sunlight reflects. */
export const KEY = 0.4;
/** Pause after which, as after a jump back in time, the exposure changes at once [s]. */
const PAUSE_S = 2;

/**
 * What a picture's light calls for: the mean of its places, each weighted with itself, so that black space does not
 * count, at `KEY`. Null: nothing can be seen.
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
  /** The next picture sets it, instead of drawing it near. */
  private anew = true;
  private wanted: number | null = null;
  private at = 0;
  private base = 0;

  /** The present one. */
  get stops(): number {
    return this.now ?? this.base;
  }

  /** It has followed a picture already. */
  get settled(): boolean {
    return !this.anew;
  }

  /** The light has changed: set the exposure at once when the next picture is measured. */
  renew(): void {
    this.anew = true;
  }

  /** Goes on to a time [s] in a light whose exposure begins at `base`; `locked` holds it. */
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

  /** Take the exposure that its picture asks for; the first time, set it at once. */
  meter(wanted: number | null): void {
    if (wanted !== null) this.wanted = wanted;
    if (this.anew) this.now = this.held(wanted ?? this.base);
    this.anew = false;
  }

  private held(stops: number): number {
    return Math.min(this.base + RANGE, Math.max(this.base - RANGE, stops));
  }
}

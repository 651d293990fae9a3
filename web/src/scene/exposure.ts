/**
 * Automatic exposure of a camera from its picture. All exposures are in photographic stops (factors of 2) above the
 * exposure for full sunlight.
 */

/** Greatest difference between a camera's exposure and its exposure when the light condition begins [stops]. */
export const RANGE = 2;
/** Time in which the exposure's error decreases by the factor e [s]. */
export const TIME_CONSTANT_S = 0.8;
/** Light for which 0 stops is the right exposure: 40 % of the light from a white blanket in sunlight. */
export const KEY = 0.4;
/** If time advances by more than this, or goes back, the exposure changes at once [s]. */
const PAUSE_S = 2;

/**
 * Returns the exposure at which a picture's mean light is `KEY`. The mean is weighted with the light itself, so that
 * black space does not count. Null if the picture is black.
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
  private atOnce = true;
  private wanted: number | null = null;
  private at = 0;
  private base = 0;

  /** The present exposure. */
  get stops(): number {
    return this.now ?? this.base;
  }

  /** Whether the exposure is locked or was set from a picture. */
  get settled(): boolean {
    return !this.atOnce;
  }

  /** Lets the next picture set the exposure at once, because the light has changed. */
  renew(): void {
    this.atOnce = true;
  }

  /** Advances the exposure to `time` [s]; `base`: exposure when the light condition begins; `locked`: fixed value. */
  follow(time: number, base: number, locked: number | null): void {
    const step = time - this.at;
    this.at = time;
    this.base = base;
    if (step < 0 || step > PAUSE_S) this.atOnce = true;
    if (locked !== null) {
      this.now = locked;
      this.atOnce = false;
    } else if (this.now !== null && this.wanted !== null) {
      const aim = this.held(this.wanted);
      this.now = aim + (this.now - aim) * Math.exp(-Math.max(0, step) / TIME_CONSTANT_S);
    }
  }

  /** Stores the exposure that the last picture needs, null if that picture is black; applies it at once if required. */
  meter(wanted: number | null): void {
    if (wanted !== null) this.wanted = wanted;
    if (this.atOnce) this.now = this.held(wanted ?? this.base);
    this.atOnce = false;
  }

  private held(stops: number): number {
    return Math.min(this.base + RANGE, Math.max(this.base - RANGE, stops));
  }
}

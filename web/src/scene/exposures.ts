import type { WebGLRenderer } from 'three';
import type { Lighting } from '../link/protocol';
import { LIGHT_OF } from './agx';
import type { Area, Quality } from './drawn';
import { Exposure, metered } from './exposure';
import { Meter } from './meter';

/**
 * Least time [ms] between two meterings (measurements of the light of a picture). Two meterings of the same camera are
 * at least twice this time apart. To read a picture, the page waits until all pending drawing is complete. This takes
 * long if the processor draws.
 */
const METERED_MS = { full: 300, low: 1500 } as const;
/** Steps of exposure per stop; a smaller change is invisible. */
const STEPS = 50;
/** For each byte, 0 to 255: product of light and exposure that the low profile displays as this byte. */
const ROOTS: readonly number[] = Array.from({ length: 256 }, (_, byte) => (byte / 255) ** 2);

/** Exposures of all cameras, each metered from the camera's own pictures. */
export class Exposures {
  private readonly cameras: ReadonlyMap<string, { readonly exposure: Exposure; at: number }>;
  private readonly meter: Meter;
  private readonly interval: number;
  private meteredAt = 0;

  constructor(names: readonly string[], renderer: WebGLRenderer, quality: Quality) {
    this.cameras = new Map(names.map((name) => [name, { exposure: new Exposure(), at: 0 }]));
    this.meter = new Meter(renderer, quality === 'full' ? LIGHT_OF : ROOTS);
    this.interval = METERED_MS[quality];
  }

  /** Rounded exposure of a camera [photographic stops above the exposure for full sunlight]. */
  stops(camera: string): number {
    return Math.round((this.cameras.get(camera)?.exposure.stops ?? 0) * STEPS) / STEPS;
  }

  /** Whether a camera's exposure is neither locked nor set from a picture yet. */
  metering(camera: string): boolean {
    return this.cameras.get(camera)?.exposure.settled === false;
  }

  /** Discards the pending metering, because the light has changed. The next pictures set the exposures at once. */
  renew(): void {
    this.meter.forget();
    for (const { exposure } of this.cameras.values()) exposure.renew();
  }

  /** Advances all exposures to the run's time `time` [s]; `base`: exposure when the light condition begins. */
  follow(time: number, base: number, locked: Lighting['locked']): void {
    const seen = this.meter.collect();
    if (seen) this.cameras.get(seen.camera)?.exposure.meter(metered(seen.lights));
    for (const [name, { exposure }] of this.cameras)
      exposure.follow(time, base, locked.find(({ camera }) => camera === name)?.stops ?? null);
  }

  /**
   * If a metering is due, starts it for the picture that was just drawn.
   *
   * @param factor factor by which the picture multiplies light.
   * @param last whether no other picture follows: it is then metered even if others were metered just before.
   */
  measure(camera: string, area: Area, factor: number, last = false): void {
    const due = this.cameras.get(camera);
    if (!due || !this.meter.free) return;
    const [now, interval] = [performance.now(), this.interval];
    const early = now - this.meteredAt < interval || now - due.at < 2 * interval;
    if (due.exposure.settled && early && !last) return;
    this.meteredAt = due.at = now;
    this.meter.ask(camera, area, factor);
  }

  dispose(): void {
    this.meter.dispose();
  }
}

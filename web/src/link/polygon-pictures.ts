/** Pictures in the look of 1972: asks the station for them, and stores them until their frames are shown. */

import type { PolygonPicture, Polygons } from './protocol';
import type { Command } from './socket';

/** Limits of an aspect in `PolygonPicture`. */
const [LEAST, GREATEST] = [0.5, 4];
/** Steps of an aspect. The page asks for pictures that are a little too high, so that few of them differ. */
const STEPS = 10;
/** Greatest number of stored pictures of a camera: 30 s, longer than any delay. */
const MOST = 1500;

/** A picture on the page: its camera, its width over its height, and the eye of an engineering view. */
export type Wanted = PolygonPicture;

/** Where the pictures in the look of 1972 come from: a live station, or the server of a recording. */
export interface PolygonSource {
  /** Sets the pictures that the page shows. */
  want(shown: readonly Wanted[]): void;
  /** The picture of a camera to show with the frame of a step; null if there is none yet. */
  at(camera: string, step: number): Polygons | null;
  dispose(): void;
}

export class PolygonPictures implements PolygonSource {
  private asked = '';
  private readonly stored = new Map<string, Polygons[]>();
  private readonly ended = new AbortController();

  constructor(private readonly send: (command: Command) => void) {
    const hidden = () => document.hidden && this.want([]);
    document.addEventListener('visibilitychange', hidden, { signal: this.ended.signal });
  }

  /** Asks for the pictures that the page shows, if they are not those that it asked for last. */
  want(shown: readonly Wanted[]): void {
    const pictures = highest(shown);
    const asked = JSON.stringify(pictures);
    if (asked === (this.asked || '[]')) return;
    this.asked = asked;
    for (const camera of this.stored.keys())
      if (!pictures.some((one) => one.camera === camera)) this.stored.delete(camera);
    this.send({ type: 'show_polygons', pictures });
  }

  /** Lets the next call of `want` ask again, because the station has a new connection to this page. */
  askAgain(): void {
    this.asked = '';
  }

  put(picture: Polygons): void {
    const stored = this.stored.get(picture.camera) ?? [];
    const last = stored.at(-1);
    if (last && picture.step < last.step) stored.length = 0; // of another session
    if (stored.length === MOST) stored.shift();
    stored.push(picture);
    this.stored.set(picture.camera, stored);
  }

  /** The newest picture of a camera that is not newer than a step, or else the oldest one; null if there is none. */
  at(camera: string, step: number): Polygons | null {
    const stored = this.stored.get(camera) ?? [];
    const later = stored.findIndex((picture) => picture.step > step);
    const past = (later < 0 ? stored.length : later) - 1;
    if (past > 0) stored.splice(0, past);
    return stored[0] ?? null;
  }

  dispose(): void {
    this.ended.abort();
  }
}

/** Returns each camera once, with the aspect of its highest picture. */
export function highest(shown: readonly Wanted[]): readonly Wanted[] {
  const found = new Map<string, Wanted>();
  for (const { camera, aspect, eye } of shown) {
    const rounded = Math.min(Math.max(Math.floor(aspect * STEPS) / STEPS, LEAST), GREATEST);
    const lower = Math.min(rounded, found.get(camera)?.aspect ?? GREATEST);
    found.set(camera, { camera, aspect: lower, eye });
  }
  return [...found.values()];
}

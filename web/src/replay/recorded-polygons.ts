/** Pictures of a recording in the look of 1972: asks the recording's server for those of the frame at the playhead. */

import { highest, type PolygonSource, type Wanted } from '../link/polygon-pictures';
import type { Polygons } from '../link/protocol';
import type { Source } from './source';

/** Time after which a request is repeated that failed, or whose pictures are still being prepared [ms]. */
const AGAIN_MS = 500;

export class RecordedPolygons implements PolygonSource {
  /** Number of answers so far: the pictures have to be shown again when it changes. */
  received = 0;
  private wanted: readonly Wanted[] = [];
  private tick = 0;
  private readonly newest = new Map<string, Polygons>();
  /** What the last answer was about; empty if it has to be repeated. */
  private answered = '';
  private waits = false;

  constructor(private readonly draw: NonNullable<Source['polygons']>) {}

  want(shown: readonly Wanted[]): void {
    this.wanted = highest(shown);
    for (const camera of this.newest.keys())
      if (!this.wanted.some((one) => one.camera === camera)) this.newest.delete(camera);
  }

  /** The newest picture of a camera; while a recording is played it is a little older than the frame. */
  at(camera: string, tick: number): Polygons | null {
    this.tick = tick;
    this.ask();
    return this.newest.get(camera) ?? null;
  }

  dispose(): void {
    this.wanted = [];
  }

  /** Asks for the pictures of the present frame, unless they are there or an answer is awaited. */
  private ask(): void {
    const { tick, wanted } = this;
    const about = JSON.stringify([tick, wanted]);
    if (this.waits || wanted.length === 0 || about === this.answered) return;
    this.waits = true;
    this.draw(tick, wanted).then(
      (pictures) => this.put(pictures, about),
      () => this.repeat(),
    );
  }

  private put(pictures: readonly Polygons[], about: string): void {
    for (const picture of pictures) this.newest.set(picture.camera, picture);
    this.received += 1;
    if (pictures.some(({ step }) => step < 0)) {
      this.repeat(); // the station prepares the look
      return;
    }
    this.waits = false;
    this.answered = about;
    this.ask();
  }

  private repeat(): void {
    setTimeout(() => {
      this.waits = false;
      this.ask();
    }, AGAIN_MS);
  }
}

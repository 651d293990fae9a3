/** The frames that pictures show: one frame for all cameras, except those whose delay differs. */

import type { Frame } from './protocol';

export class PictureFrames {
  /** `own`: frames of the cameras that show another one. */
  constructor(
    readonly frame: Frame,
    private readonly own: ReadonlyMap<string, Frame> | null = null,
  ) {}

  /** The frame that the picture of a camera shows. */
  of(camera: string): Frame {
    return this.own?.get(camera) ?? this.frame;
  }

  /** Whether some cameras show a frame of their own. */
  get differ(): boolean {
    return this.own !== null;
  }
}

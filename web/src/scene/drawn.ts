/** Drawing profile, and the pictures to draw, each with its position. */

/** `full` needs a graphics card; `low` is fast even if the processor computes the pictures. */
export type Quality = 'full' | 'low';

export interface Rect {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** One picture: the camera's name, and the picture's position on the canvas [CSS px from its top left]. */
export interface View {
  readonly camera: string;
  readonly rect: Rect;
  /** Black and white, with noise. */
  readonly early: boolean;
}

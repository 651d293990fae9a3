/** Drawing profile, and pictures with their positions. */

/** `full` is for graphics hardware; `low` is quick where the processor draws. */
export type Quality = 'full' | 'low';

export interface Rect {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** One picture: the camera's name, and the position on the canvas [CSS px from its top left]. */
export interface View {
  readonly camera: string;
  readonly rect: Rect;
  /** Black and white, with noise. */
  readonly early: boolean;
}

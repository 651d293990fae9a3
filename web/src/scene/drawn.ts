/** What is drawn: which profile, and which pictures where. */

/** `full` is for graphics hardware; `low` is quick where the processor draws. */
export type Quality = 'full' | 'low';

export interface Rect {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** One picture: a camera by name, and where on the canvas it goes [CSS px from its top left]. */
export interface View {
  readonly camera: string;
  readonly rect: Rect;
  /** Black and white, with noise. */
  readonly early: boolean;
}

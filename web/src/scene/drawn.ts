/** Drawing profile, and the pictures to draw, each with its position. */

/**
 * A wider picture shows the camera's field of view in its middle, as high as a picture of this width over its height
 * would. Assumed: half-way between television (4:3) and a wide monitor (5:3).
 */
export const ASPECT = 1.5;

/** `full` needs a graphics card; `low` is fast even if the processor computes the pictures. */
export type Quality = 'full' | 'low';

/** Part of a picture: 0 to 1 from its left and from its top. */
export interface Part {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

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
  /** The part that no other picture covers: the middle of the camera's field of view is in the middle of this part. */
  readonly free: Part;
  /** Black and white, with noise. */
  readonly early: boolean;
}

/** Part of a still picture, drawn with one of its samples. */
export interface Piece {
  readonly view: View;
  /** Rectangle within the picture's. */
  readonly part: Rect;
  /** Index in `SAMPLES`. */
  readonly sample: number;
}

/** Part of a canvas [px from its bottom left, as in WebGL]. */
export interface Area {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Returns the pixels of a rectangle; `height`: height of the canvas [CSS px]; `scale`: pixels for each CSS px. */
export function areaOf({ left, top, width, height: high }: Rect, height: number, scale: number): Area {
  const [x, right] = [left, left + width].map((side) => Math.round(scale * side)) as [number, number];
  const [y, above] = [height - top - high, height - top].map((side) => Math.round(scale * side)) as [
    number,
    number,
  ];
  return { x, y, width: right - x, height: above - y };
}

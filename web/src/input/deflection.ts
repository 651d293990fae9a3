/** Axes of the hand controllers and of the selected camera, each in [-1, 1]. */

import { clamp } from '../basics/clamp';

/** THC X, Y, Z; RHC roll, pitch, yaw; the telescope (positive: longer); the selected camera. */
export const AXES = ['X', 'Y', 'Z', 'roll', 'pitch', 'yaw', 'telescope', 'pan', 'tilt', 'zoom'] as const;

export const [X, Y, Z, ROLL, PITCH, YAW, TELESCOPE, PAN, TILT, ZOOM] = [
  0, 1, 2, 3, 4, 5, 6, 7, 8, 9,
] as const;

/** A value for each of `AXES`. */
export type Deflection = readonly number[];

export const ZERO: Deflection = AXES.map(() => 0);

/** The two hand controllers, by their axes. */
export const HANDS = { thc: [X, Y, Z], rhc: [ROLL, PITCH, YAW] } as const;
export type Hand = keyof typeof HANDS;

/** Sum of all devices, each axis limited to full deflection. */
export function sum(...parts: readonly Deflection[]): Deflection {
  return ZERO.map((_, axis) => clamp(parts.reduce((total, part) => total + (part[axis] ?? 0), 0)));
}

export function isZero(deflection: Deflection): boolean {
  return deflection.every((value) => value === 0);
}

export function equal(a: Deflection, b: Deflection): boolean {
  return a.every((value, axis) => value === b[axis]);
}

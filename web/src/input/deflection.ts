/** Seven stick axes in [-1, 1]: X, Y, Z of the THC, roll, pitch, yaw of the RHC, and the telescope. */

export type Deflection = readonly [
  x: number,
  y: number,
  z: number,
  roll: number,
  pitch: number,
  yaw: number,
  telescope: number,
];

export const X = 0;
export const Y = 1;
export const Z = 2;
export const ROLL = 3;
export const PITCH = 4;
export const YAW = 5;
/** Positive: longer. */
export const TELESCOPE = 6;

export const ZERO: Deflection = [0, 0, 0, 0, 0, 0, 0];

export function map(f: (axis: number) => number): Deflection {
  return [f(0), f(1), f(2), f(3), f(4), f(5), f(6)];
}

/** Both devices together, no axis past full deflection. */
export function sum(a: Deflection, b: Deflection): Deflection {
  return map((axis) => Math.max(-1, Math.min(1, (a[axis] ?? 0) + (b[axis] ?? 0))));
}

export function isZero(deflection: Deflection): boolean {
  return deflection.every((value) => value === 0);
}

export function equal(a: Deflection, b: Deflection): boolean {
  return a.every((value, axis) => value === b[axis]);
}

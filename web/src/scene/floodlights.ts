import { Color, type Matrix4, type Vector3 } from 'three';
import type { Light } from '../link/protocol';
import type { Body } from './bodies';

const FLOOD = new Color('#ffe9c9');
const SPOT = new Color('#fff2dc');
/** Fraction of a spot's cone in which its light fades. */
export const PENUMBRA = 0.7;

/** A lamp on its body. */
export interface Lamp {
  readonly light: Light;
  readonly body: Body;
  /** Pose in its body's frame. The lamp shines along x. */
  readonly place: Matrix4;
  readonly colour: Color;
}

/** All lamps, in the order of the bodies. */
export function lampsOf(bodies: readonly Body[]): readonly Lamp[] {
  return bodies.flatMap((body) =>
    body.lights.map(({ light, place }) => ({ light, body, place, colour: isSpot(light) ? SPOT : FLOOD })),
  );
}

/** Returns whether a lamp has a beam. A lamp without a beam shines in all directions. */
export function isSpot({ cone }: Light): boolean {
  return cone <= Math.PI / 2;
}

/** Writes the position of a lamp in the scene to `at`, and its direction to `along`. */
export function lampPose({ body, place }: Lamp, at: Vector3, along: Vector3): void {
  at.setFromMatrixPosition(place).applyMatrix4(body.group.matrixWorld);
  along.set(1, 0, 0).transformDirection(place).transformDirection(body.group.matrixWorld);
}

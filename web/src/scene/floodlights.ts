import { Color, type Matrix4, type Vector3 } from 'three';
import type { Light } from '../link/protocol';
import type { Body } from './bodies';

const FLOOD = new Color('#ffe9c9');
const SPOT = new Color('#fff2dc');
/** Part of a spot's cone over which it fades. */
export const PENUMBRA = 0.7;

/** A lamp on its body. */
export interface Lamp {
  readonly light: Light;
  readonly body: Body;
  /** In its body's frame; it looks along x. */
  readonly place: Matrix4;
  readonly colour: Color;
}

/** All lamps, in the order of the bodies. */
export function lampsOf(bodies: readonly Body[]): readonly Lamp[] {
  return bodies.flatMap((body) =>
    body.lights.map(({ light, place }) => ({ light, body, place, colour: isSpot(light) ? SPOT : FLOOD })),
  );
}

/** Whether it has a beam; else it shines all round. */
export function isSpot({ cone }: Light): boolean {
  return cone <= Math.PI / 2;
}

/** Position of a lamp in the scene, and its direction. */
export function standing({ body, place }: Lamp, at: Vector3, along: Vector3): void {
  at.setFromMatrixPosition(place).applyMatrix4(body.group.matrixWorld);
  along.set(1, 0, 0).transformDirection(place).transformDirection(body.group.matrixWorld);
}

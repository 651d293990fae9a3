/** Overlay of a monitor's picture: lens, axes, minimum clearance, contacts, and forces of contacts and disturbances. */

import type { ClosestPoints, Frame, Vec3 } from '../link/protocol';
import type { GapLine, Touch } from '../panel/monitors/gap-overlay';
import type { Picture } from '../panel/monitors/picture';
import type { PushArrow } from '../panel/monitors/push-overlay';
import type { Scene } from '../scene';
import type { View } from '../scene/drawn';

/** Least force that is drawn [N]; parts that only touch push each other with less. */
const LEAST_N = 0.5;
/** Length of an arrow for a force of 100 N, and the greatest length [m]; an arrow grows with the square root. */
const [HUNDRED_N, LONGEST] = [0.6, 2.5];

export interface Over {
  readonly frame: Frame;
  /** The minimum clearance to draw, and whether it is a caution. */
  readonly gap: ClosestPoints | null;
  readonly caution: boolean;
  /** Whether the sticks drive one joint: they then have no direction in a picture. */
  readonly oneJoint: boolean;
}

export function overlay(scene: Scene, picture: Picture, view: View, over: Over): void {
  const { frame, gap, caution, oneJoint } = over;
  const [w, x, y, z] = frame.display.axes;
  picture.setLens(scene.cameras.setting(picture.camera.name), view.rect, view.free);
  picture.setAxes(scene.cameras.directions(view.camera, [w, x, y, z]), !oneJoint);
  const line = gap && gapLine(scene, view, gap, caution);
  picture.setGap(line, touches(scene, view, frame), view.rect);
  picture.setPushes(pushes(scene, view, frame));
}

function gapLine(
  scene: Scene,
  { camera, rect, free }: View,
  gap: ClosestPoints,
  caution: boolean,
): GapLine | null {
  const { width, height } = rect;
  const ends = scene.cameras.segment(camera, width / height, gap.point_a, gap.point_b, free);
  if (!ends) return null;
  const [a, b] = ends;
  return {
    a: { x: a.x * width, y: a.y * height },
    b: { x: b.x * width, y: b.y * height },
    caution,
  };
}

function touches(scene: Scene, { camera, rect, free }: View, { work, display }: Frame): readonly Touch[] {
  const { width, height } = rect;
  return display.contacts.flatMap(({ plane }, i) => {
    const at = scene.cameras.project(camera, width / height, plane, free);
    return at.visible
      ? [{ at: { x: at.x * width, y: at.y * height }, essential: work.contacts[i]?.essential ?? false }]
      : [];
  });
}

/**
 * Returns the arrows of the forces of contacts and disturbances. An arrow begins where the force acts, and points along
 * the force on the second part or on the disturbed body.
 */
function pushes(scene: Scene, { camera, rect, free }: View, { display }: Frame): readonly PushArrow[] {
  const { width, height } = rect;
  return display.pushes.flatMap(({ point, force }) => {
    const newtons = Math.hypot(...force);
    if (newtons < LEAST_N) return [];
    const length = Math.min(LONGEST, HUNDRED_N * Math.sqrt(newtons / 100)) / newtons;
    const end = point.map((each, i) => each + length * (force[i] ?? 0)) as unknown as Vec3;
    const ends = scene.cameras.segment(camera, width / height, point, end, free);
    if (!ends) return [];
    const [from, to] = ends.map(({ x, y }) => ({ x: x * width, y: y * height }));
    return from && to ? [{ from, to, newtons }] : [];
  });
}

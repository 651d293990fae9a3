/** Overlay of a monitor's picture: lens, axes, minimum clearance, contacts. */

import type { ClosestPoints, Frame } from '../link/protocol';
import type { GapLine, Touch } from '../panel/monitors/gap-overlay';
import type { Picture } from '../panel/monitors/picture';
import type { Scene } from '../scene';
import type { View } from '../scene/drawn';

export interface Over {
  readonly frame: Frame;
  /** The minimum clearance to draw, and whether it is a caution. */
  readonly gap: ClosestPoints | null;
  readonly caution: boolean;
}

export function overlay(scene: Scene, picture: Picture, view: View, over: Over): void {
  const { frame, gap, caution } = over;
  const [w, x, y, z] = frame.display.axes;
  picture.setLens(scene.cameras.setting(picture.camera.name), view.rect);
  picture.setAxes(scene.cameras.directions(view.camera, [w, x, y, z]));
  const line = gap && gapLine(scene, view, gap, caution);
  picture.setGap(line, touches(scene, view, frame), view.rect);
}

function gapLine(scene: Scene, { camera, rect }: View, gap: ClosestPoints, caution: boolean): GapLine | null {
  const { width, height } = rect;
  const ends = scene.cameras.segment(camera, width / height, gap.point_a, gap.point_b);
  if (!ends) return null;
  const [a, b] = ends;
  return {
    a: { x: a.x * width, y: a.y * height },
    b: { x: b.x * width, y: b.y * height },
    caution,
  };
}

function touches(scene: Scene, { camera, rect }: View, { work, display }: Frame): readonly Touch[] {
  const { width, height } = rect;
  return display.contacts.flatMap(({ plane }, i) => {
    const at = scene.cameras.project(camera, width / height, plane);
    return at.visible
      ? [{ at: { x: at.x * width, y: at.y * height }, essential: work.contacts[i]?.essential ?? false }]
      : [];
  });
}

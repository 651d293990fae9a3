/** The end effector and the held payload at the place where the task needs them, as a green ghost. */

import { Matrix4, Quaternion, type Scene as Stage, Vector3 } from 'three';
import type { Frame } from '../link/protocol';
import { isThere } from '../task/to-go';
import type { Body } from './bodies';
import { Ghost } from './ghost';

/** Colour of the ghost, equal to the page's colour of values that have reached their tolerance. */
const GREEN = '#a9e3bf';
/** A payload can fill a picture; behind its ghost, everything has to stay visible. */
const FACES = { fill: 0.04, rim: 0.3 };
const [motion, pose] = [new Matrix4(), new Matrix4()];
const [place, turn, size] = [new Vector3(), new Quaternion(), new Vector3()];

export class GoalGhost {
  private readonly ghost: Ghost;
  private readonly bodies: readonly Body[];

  /**
   * @param effector names of the end effector's bodies.
   * @param payloads names of the payloads that the end effector can hold.
   */
  constructor(
    stage: Stage,
    bodies: readonly Body[],
    private readonly effector: ReadonlySet<string>,
    payloads: ReadonlySet<string>,
  ) {
    this.bodies = bodies.filter(({ group: { name } }) => effector.has(name) || payloads.has(name));
    this.ghost = new Ghost(stage, this.bodies, GREEN, FACES);
  }

  /** Shows the place of a frame's `to_go`; the bodies must already have the poses of this frame. */
  set({ display: { to_go }, work }: Frame, now: number | null): void {
    if (!to_go || to_go.shift.length === 0 || isThere(to_go)) {
      this.ghost.set(null, now);
      return;
    }
    const held = new Set(work.cargo.flatMap((cargo) => (cargo.held ? [cargo.name] : [])));
    const [x = 0, y = 0, z = 0, w = 1, i = 0, j = 0, k = 0] = to_go.shift;
    motion.compose(place.set(x, y, z), turn.set(i, j, k, w), size.set(1, 1, 1));
    const poses = this.bodies.flatMap(({ group }) => {
      const moves = this.effector.has(group.name) || held.has(group.name);
      pose.copy(group.matrixWorld);
      if (moves) pose.premultiply(motion);
      pose.decompose(place, turn, size);
      return [place.x, place.y, place.z, turn.w, turn.x, turn.y, turn.z];
    });
    this.ghost.set(poses, now);
  }

  /** Present opacity: 0 is invisible. */
  get opacity(): number {
    return this.ghost.opacity;
  }

  setVisible(on: boolean): void {
    this.ghost.setVisible(on);
  }

  dispose(): void {
    this.ghost.dispose();
  }
}

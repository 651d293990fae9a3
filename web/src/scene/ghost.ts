import {
  EdgesGeometry,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  Object3D,
  Quaternion,
  type Scene as Stage,
  Vector3,
} from 'three';
import type { Body } from './bodies';
import type { Quality } from './index';

/** As what is commanded. */
const BLUE = '#78bdf7';
const FILL = 0.2;
const EDGE = 0.3;
/** It comes and goes in this time [s]. */
const FADE_S = 0.15;
/** Faces that meet at more than this have an edge [deg]. */
const CORNER = 30;
/** Numbers a body in a look ahead's poses. */
const POSE = 7;

const ONE = new Vector3(1, 1, 1);
const place = new Vector3();
const turn = new Quaternion();

/** The arm, and what it carries, where holding the sticks would take them. */
export class Ghost {
  private readonly fill = new MeshBasicMaterial({
    color: BLUE,
    transparent: true,
    opacity: 0,
    depthWrite: false,
    toneMapped: false,
    polygonOffset: true,
    polygonOffsetFactor: 1,
  });
  private readonly edge = new LineBasicMaterial({
    color: BLUE,
    transparent: true,
    opacity: 0,
    depthWrite: false,
    toneMapped: false,
  });
  private readonly parts: readonly Object3D[];
  private readonly lines: LineSegments[] = [];
  private shown = 0;
  private at = performance.now();

  constructor(stage: Stage, bodies: readonly Body[], quality: Quality) {
    this.parts = bodies.map((body) => {
      const part = new Object3D();
      part.matrixAutoUpdate = false;
      for (const child of body.group.children) if (child instanceof Mesh) this.add(part, child, quality);
      stage.add(part);
      return part;
    });
    this.setVisible(false);
  }

  /** Puts it there: seven numbers a body, as in `Frame.poses`; null: it fades away. */
  set(poses: readonly number[] | null, now: number): void {
    const step = Math.max(0, now - this.at) / 1000 / FADE_S;
    this.at = now;
    this.shown = Math.min(1, Math.max(0, this.shown + (poses ? step : -step)));
    this.fill.opacity = FILL * this.shown;
    this.edge.opacity = EDGE * this.shown;
    if (!poses) return;
    this.parts.forEach((part, i) => {
      const first = POSE * i;
      place.fromArray(poses, first);
      turn.set(poses[first + 4] ?? 0, poses[first + 5] ?? 0, poses[first + 6] ?? 0, poses[first + 3] ?? 1);
      part.matrix.compose(place, turn, ONE);
      part.updateMatrixWorld(true);
    });
  }

  /** Whether the pictures drawn next show it. */
  setVisible(on: boolean): void {
    for (const part of this.parts) part.visible = on && this.shown > 0;
  }

  dispose(): void {
    for (const part of this.parts) part.removeFromParent();
    for (const { geometry } of this.lines) geometry.dispose();
    this.fill.dispose();
    this.edge.dispose();
  }

  private add(part: Object3D, { geometry }: Mesh, quality: Quality): void {
    const mesh = new Mesh(geometry, this.fill);
    mesh.renderOrder = 1;
    mesh.matrixAutoUpdate = false;
    part.add(mesh);
    if (quality === 'low') return;
    const lines = new LineSegments(new EdgesGeometry(geometry, CORNER), this.edge);
    lines.renderOrder = 1;
    lines.matrixAutoUpdate = false;
    this.lines.push(lines);
    part.add(lines);
  }
}

/** The two monitors and the one canvas behind them. */

import { small } from './format';
import { el } from './panel/dom';
import type { GapLine, Touch } from './panel/gap-overlay';
import { FARTHEST } from './panel/gap-scale';
import { Monitor } from './panel/monitor';
import type { View as DeskView } from './panel/part';
import type { Frame, Level, Near, Welcome } from './protocol';
import type { Drawing } from './quality';
import { Scene, type View } from './scene';
import type { DrawnBody } from './scene/bodies';

/** What the monitors show at first, where the scenario has these cameras. */
const FIRST = ['B', 'WR'] as const;
/** Colours of the gap's line, as `--caution` and `--ink`. */
const [CAUTION, CALM] = ['#ffb534', '#d9dbdc'];

export class Pictures {
  readonly canvas = el('canvas', { class: 'scene', 'aria-hidden': 'true' });
  readonly monitors: readonly [Monitor, Monitor];
  private readonly scene: Scene;
  private inHand = 0;
  private plane = false;

  constructor(welcome: Welcome, drawing: Drawing) {
    const monitor = (index: number) =>
      new Monitor(`MON ${index + 1}`, welcome.cameras, FIRST[index] ?? '', {
        taken: () => this.take(index),
      });
    this.monitors = [monitor(0), monitor(1)];
    this.take(0);
    this.scene = new Scene(this.canvas, welcome, drawing.quality);
  }

  /** The monitor that camera keys act on. */
  get hand(): Monitor {
    return this.monitors[this.inHand === 0 ? 0 : 1];
  }

  takeOther(): void {
    this.take(1 - this.inHand);
  }

  /** The bodies as they are drawn now. */
  get bodies(): readonly DrawnBody[] {
    return this.scene.drawn;
  }

  /** Whether the separating plane is drawn. */
  get showsPlane(): boolean {
    return this.plane;
  }

  /** Shows or hides the separating plane; returns whether it is shown now. */
  togglePlane(): boolean {
    this.plane = !this.plane;
    return this.plane;
  }

  /** `clearance`: what the narrowest gap calls for. */
  draw(frame: Frame, clearance: Level): void {
    const over = this.canvas.getBoundingClientRect();
    const caution = clearance !== 'info';
    const gap = drawnGap(frame.work.nearest);
    this.scene.setPoses(frame.poses);
    this.scene.setGap(gap, caution ? CAUTION : CALM, this.plane);
    const views = this.monitors.map((monitor): View => {
      const { left, top, width, height } = monitor.picture.getBoundingClientRect();
      const rect = { left: left - over.left, top: top - over.top, width, height };
      return { camera: monitor.camera, rect };
    });
    this.scene.draw(views);
    const [w, x, y, z] = frame.axes;
    this.monitors.forEach((monitor, i) => {
      monitor.setAxes(this.scene.directions(monitor.camera, [w, x, y, z]));
      const view = views[i];
      if (!view) return;
      const line = gap && this.line(view, gap, caution);
      monitor.setGap(line, this.touches(view, frame.work.contacts), view.rect);
    });
  }

  /** Time codes and figures; `age` of the picture in seconds, null where it is a recorded one. */
  setTime({ frame, units }: Pick<DeskView, 'frame' | 'units'>, age: number | null): void {
    const { nearest } = frame.work;
    for (const monitor of this.monitors) {
      monitor.setTime(frame, age);
      if (nearest) monitor.setGapText(`${small(nearest.clearance, units.gap)} ${units.gap.name}`);
    }
  }

  dispose(): void {
    this.scene.dispose();
  }

  private line({ camera, rect }: View, near: Near, caution: boolean): GapLine | null {
    const { width, height } = rect;
    const ends = this.scene.segment(camera, width / height, near.point_a, near.point_b);
    if (!ends) return null;
    const [a, b] = ends;
    return {
      a: { x: a.x * width, y: a.y * height },
      b: { x: b.x * width, y: b.y * height },
      caution,
    };
  }

  private touches({ camera, rect }: View, contacts: readonly Near[]): readonly Touch[] {
    const { width, height } = rect;
    return contacts.flatMap(({ point_a, point_b, essential }) => {
      const [ax, ay, az] = point_a;
      const [bx, by, bz] = point_b;
      const at = this.scene.project(camera, width / height, [(ax + bx) / 2, (ay + by) / 2, (az + bz) / 2]);
      return at.visible ? [{ at: { x: at.x * width, y: at.y * height }, essential }] : [];
    });
  }

  private take(index: number): void {
    this.inHand = index;
    this.monitors.forEach((monitor, i) => {
      monitor.setInHand(i === index);
    });
  }
}

/** The gap that is worth a line: none that is wide, none where the two touch. */
export function drawnGap(nearest: Near | null): Near | null {
  return nearest && nearest.clearance > 0 && nearest.clearance < FARTHEST ? nearest : null;
}

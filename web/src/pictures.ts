/** The two monitors and the one canvas behind them. */

import { el } from './panel/dom';
import { Monitor } from './panel/monitor';
import type { Frame, Welcome } from './protocol';
import type { Drawing } from './quality';
import { Scene } from './scene';

/** What the monitors show at first, where the scenario has these cameras. */
const FIRST = ['B', 'WR'] as const;

export class Pictures {
  readonly canvas = el('canvas', { class: 'scene', 'aria-hidden': 'true' });
  readonly monitors: readonly [Monitor, Monitor];
  private readonly scene: Scene;
  private inHand = 0;

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

  draw(frame: Frame): void {
    const over = this.canvas.getBoundingClientRect();
    this.scene.setPoses(frame.poses);
    const views = this.monitors.map((monitor) => {
      const { left, top, width, height } = monitor.picture.getBoundingClientRect();
      const rect = { left: left - over.left, top: top - over.top, width, height };
      return { camera: monitor.camera, rect };
    });
    this.scene.draw(views);
    const [w, x, y, z] = frame.axes;
    for (const monitor of this.monitors) monitor.setAxes(this.scene.directions(monitor.camera, [w, x, y, z]));
  }

  /** Time codes; `age` of the picture in seconds, null where it is a recorded one. */
  setTime(frame: Frame, age: number | null): void {
    for (const monitor of this.monitors) monitor.setTime(frame, age);
  }

  dispose(): void {
    this.scene.dispose();
  }

  private take(index: number): void {
    this.inHand = index;
    this.monitors.forEach((monitor, i) => {
      monitor.setInHand(i === index);
    });
  }
}

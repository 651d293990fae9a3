/** The two monitors: the cameras that they show, and the selected picture, on which the camera keys act. */

import type { Turning } from '../input/camera-hand';
import type { Camera } from '../link/protocol';
import { Monitor } from '../panel/monitors/monitor';

/** A digit that is pressed again within this time selects one of the cameras 11 to 20 [ms]. */
const AGAIN_MS = 700;
const BANK = 10;

export interface MonitorsListener {
  /** Called when a monitor shows another camera, or is split. */
  changed(): void;
  /** Called when a camera was chosen for a monitor. */
  chosen(): void;
  /** Called when the user requests the next centre of the engineering views. */
  round(): void;
  orbited(camera: Camera, right: number, upwards: number, nearer: number, aside?: boolean): void;
  /** Switches a monitor to the look of 1972, or back; absent if nothing computes this look. */
  seventies?: (index: 0 | 1) => void;
  /** Opens a window that shows what decides the order in a monitor's picture in the look of 1972; absent as above. */
  planes?: (index: 0 | 1) => void;
  /** Opens a monitor in a secondary window; absent if the page opens no secondary windows. */
  tearOff?: (index: 0 | 1) => void;
  /** Whether dragging a picture turns its camera. */
  readonly turns: boolean;
}

export class Monitors {
  readonly both: readonly [Monitor, Monitor];
  /** Whether cameras have been chosen by `begin`, the user, a recording or another page. */
  chosen = false;
  private selected = 0;
  private slowly = false;
  private digit = { index: -1, at: 0 };

  constructor(
    private readonly cameras: readonly Camera[],
    first: Camera,
    private readonly listener: MonitorsListener,
  ) {
    const { seventies, planes, tearOff, turns } = listener;
    const monitor = (index: 0 | 1) =>
      new Monitor(`MON ${index + 1}`, cameras, first, {
        taken: (half) => this.take(index, half),
        choose: (camera) => this.choose(camera),
        split: () => this.toggleSplit(),
        slow: () => this.toggleSlow(),
        round: () => listener.round(),
        orbited: (camera, ...by) => listener.orbited(camera, ...by),
        turns,
        ...(seventies ? { seventies: () => seventies(index) } : {}),
        ...(planes ? { planes: () => planes(index) } : {}),
        ...(tearOff ? { tearOff: () => tearOff(index) } : {}),
      });
    this.both = [monitor(0), monitor(1)];
    this.take(0);
  }

  /** The selected monitor, on which the camera keys act. */
  get hand(): Monitor {
    return this.both[this.selected === 0 ? 0 : 1];
  }

  /** The selected camera, on which the camera keys act. */
  get camera(): Camera {
    return this.hand.picture.camera;
  }

  /** Deflections of the selected camera's switches, commanded by a drag, a pinch or the mouse wheel. */
  get turning(): Turning {
    return this.hand.picture.turning(performance.now());
  }

  /** Whether the drives turn at their low speed. */
  get slow(): boolean {
    return this.slowly;
  }

  /** Names of the cameras on the monitors. */
  get shown(): readonly (readonly string[])[] {
    return this.both.map(({ pictures }) => pictures.map(({ camera }) => camera.name));
  }

  /** Selects a monitor. */
  take(index: number, half?: number): void {
    this.selected = index;
    this.both.forEach((monitor, i) => {
      const own = monitor.halves.indexOf(monitor.picture);
      monitor.setInHand(i === index ? (half ?? own) : null);
    });
  }

  /** Selects the next picture: the right half of a split monitor, or else the other monitor. */
  takeOther(): void {
    const { hand } = this;
    if (hand.split && hand.picture === hand.halves[0]) this.take(this.selected, 1);
    else this.take(1 - this.selected, 0);
  }

  /** Puts a camera on the selected monitor. */
  choose(camera: Camera): void {
    this.hand.choose(camera);
    this.chosen = true;
    this.listener.chosen();
    this.listener.changed();
  }

  /** Puts the camera of a digit on the selected monitor. A digit pressed twice means one of the cameras 11 to 20. */
  chooseDigit(index: number, now: number): void {
    const again = index === this.digit.index && now - this.digit.at < AGAIN_MS;
    this.digit = { index: again ? -1 : index, at: now };
    const camera = this.cameras[again ? index + BANK : index];
    if (camera) this.choose(camera);
  }

  /** Puts the next or the previous camera on the selected monitor. */
  step(by: number): void {
    this.hand.step(by);
    this.chosen = true;
    this.listener.changed();
  }

  /** Shows one camera, or two in halves, on a monitor, unless it shows them already. */
  show(index: number, names: readonly string[]): void {
    if (this.shown[index]?.join() === names.join()) return;
    this.both[index === 0 ? 0 : 1].show(names);
    this.chosen = true;
    this.take(this.selected);
    this.listener.changed();
  }

  /** Shows one camera on each monitor at the start of a run. */
  begin(cameras: readonly Camera[]): void {
    this.chosen = true;
    cameras.forEach((camera, i) => {
      this.both[i === 0 ? 0 : 1].choose(camera);
    });
    this.listener.changed();
  }

  toggleSplit(): void {
    this.hand.toggleSplit();
    this.take(this.selected);
    this.listener.changed();
  }

  toggleSlow(): void {
    this.slowly = !this.slowly;
    for (const monitor of this.both) monitor.setSlow(this.slowly);
  }
}

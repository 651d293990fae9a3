/** The pictures on the canvas: their positions on the page, how often each is drawn, and which are due now. */

import type { Camera } from '../link/protocol';
import { inset } from '../page/room';
import type { Matrix } from '../panel/monitors/matrix';
import type { Picture } from '../panel/monitors/picture';
import type { PolygonPane } from '../panel/monitors/polygon-pane';
import type { Quality, Rect } from '../scene/drawn';
import type { Monitors } from './monitors';

/** How often a tile and the plan are drawn: 3 means at every third drawing of the page. A monitor always is. */
export const PACES = { full: { tile: 3, plan: 8 }, low: { tile: 6, plan: 24 } } as const;

/** A picture on the canvas. */
export interface Pane {
  readonly camera: Camera;
  readonly element: HTMLElement;
  readonly pace: number;
  /** The picture of a monitor; null for a tile. */
  readonly picture: Picture | null;
  /** Draws the picture in the look of 1972, on its own canvas, from the station's polygons. */
  readonly pane: PolygonPane;
  /** Whether the picture has this look. */
  readonly polygons: boolean;
}

/** Index of the view of all cameras among the looks of 1972; those before it are the monitors'. */
export const ALL = 2;

export class Panes {
  private readonly tile: number;
  private readonly stamps = new WeakMap<HTMLElement, string>();
  private layout = '';

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly monitors: Monitors,
    private readonly matrix: Matrix,
    quality: Quality,
  ) {
    this.tile = PACES[quality].tile;
  }

  /**
   * The pictures on the page. `open`: all cameras are shown in place of the monitors; `seventies`: for each monitor,
   * and for the view of all cameras, whether it has the look of 1972.
   */
  all(open: boolean, seventies: readonly boolean[] = []): readonly Pane[] {
    if (open) {
      return this.matrix.tiles.map(({ camera, picture, polygons }) => ({
        camera,
        element: picture,
        pace: this.tile,
        picture: null,
        pane: polygons,
        polygons: seventies[ALL] === true,
      }));
    }
    return this.monitors.both.flatMap(({ element, pictures }, i) =>
      element.isConnected
        ? pictures.map((picture) => {
            const { camera, element: area } = picture;
            const polygons = seventies[i] === true;
            return { camera, element: area, pace: 1, picture, pane: picture.polygons, polygons };
          })
        : [],
    );
  }

  /**
   * Returns the pictures to draw now (`due`). `complete`: all other pictures already show this frame.
   *
   * @param state text that changes with the content of the pictures, but not with their exposures.
   * @param looks function that returns a text or number that changes with what only a camera's picture shows.
   * @param count number of drawings of the page so far.
   * @param wiped whether the canvas was wiped; every picture is then due.
   */
  due(
    panes: readonly Pane[],
    state: string,
    looks: (camera: string) => string | number,
    open: boolean,
    count: number,
    wiped: boolean,
  ): { readonly due: readonly Pane[]; readonly complete: boolean } {
    const look = ({ camera: { name } }: Pane) => `${name} ${looks(name)}`;
    // If MON 2 is in a corner of MON 1, drawing MON 1 overwrites MON 2. All pictures are then drawn together.
    const together = this.inset(open) ? panes.map(look).join() : null;
    let complete = true;
    const due = panes.filter((pane, i) => {
      const stamp = `${state} ${together ?? look(pane)}`;
      if (this.stamps.get(pane.element) === stamp && !wiped) return false;
      if ((count + i) % pane.pace !== 0 && !wiped) {
        complete = false;
        return false;
      }
      this.stamps.set(pane.element, stamp);
      return true;
    });
    return { due, complete };
  }

  /** Stores the page's present layout; returns whether pictures were added, removed or moved since the last call. */
  takeLayout(panes: readonly Pane[], open: boolean): boolean {
    const layout = this.laidOut(panes, open);
    const changed = layout !== this.layout;
    this.layout = layout;
    return changed;
  }

  /** Returns whether the pictures still have the positions of the stored layout. */
  isLaidOut(panes: readonly Pane[], open: boolean): boolean {
    return this.laidOut(panes, open) === this.layout;
  }

  /** Returns the position of an element on the canvas. */
  rectOf(element: HTMLElement): Rect {
    const over = this.canvas.getBoundingClientRect();
    const { left, top, width, height } = element.getBoundingClientRect();
    return { left: left - over.left, top: top - over.top, width, height };
  }

  /** Whether MON 2 is in a corner of MON 1. */
  private inset(open: boolean): boolean {
    return inset() && !open && this.monitors.both.every(({ element }) => element.isConnected);
  }

  /** Returns a text that changes with everything on which the pictures' positions depend. */
  private laidOut(panes: readonly Pane[], open: boolean): string {
    const { clientWidth, clientHeight } = this.canvas;
    return [clientWidth, clientHeight, open, ...panes.map(({ element }) => element.clientWidth)].join();
  }
}

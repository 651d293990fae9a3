/** All cameras at once. Each tile names the subjects that its camera sees. Clearance and lamps are below the tiles. */

import type { Subject } from '../../cameras/best-pair';
import { type Age, isStale } from '../../link/age';
import type { Camera } from '../../link/protocol';
import { button, el, group, setAttribute, setClass, setPressed, setStyle, setText } from '../parts/dom';
import { fitPane } from './picture';
import { type Plan, plan } from './plan';
import { PolygonPane } from './polygon-pane';

/** Columns and rows of tiles. The size of a tile does not depend on the number of cameras. */
const [ACROSS, DOWN] = [5, 3];

export interface Tile {
  readonly camera: Camera;
  /** Transparent element over the scene's canvas. */
  readonly picture: HTMLElement;
  /** The picture in the look of 1972, hidden while the scene draws this picture. */
  readonly polygons: PolygonPane;
}

export interface MatrixListener {
  chosen(camera: Camera): void;
  /** Opens all cameras in a secondary window. Undefined if these cameras are already in one. */
  tearOff?: () => void;
  /** Switches all tiles to the look of 1972, or back. Undefined if nothing computes this look. */
  seventies?: () => void;
}

export class Matrix {
  readonly element: HTMLElement;
  readonly strip: HTMLElement;
  readonly tiles: readonly Tile[];
  readonly plan: Plan;
  private readonly parts;
  private readonly views = el('div', { class: 'pair-words' });
  private readonly lentTo = {
    clearance: el('div', { class: 'lent' }),
    lamps: el('div', { class: 'lent lamps-lent' }),
  };
  private seventiesKey: HTMLButtonElement | null = null;
  private back: (() => void)[] = [];

  constructor(cameras: readonly Camera[], listener: MatrixListener) {
    this.plan = plan(cameras.filter(({ kind }) => kind === 'camera'));
    this.parts = cameras.map((camera) => {
      const pane = el('div', { class: 'pane' });
      const polygons = new PolygonPane();
      const picture = el(
        'div',
        { class: 'tile-picture' },
        ...polygons.elements,
        ...(camera.pane ? [pane] : []),
      );
      const lost = el('p', { class: 'lost' }, el('b', {}, 'Picture lost'), el('span'));
      picture.append(lost);
      const tags = el('span', { class: 'tags' });
      const words = el('span', { class: 'words' });
      const title = el('span', { class: 'title' }, camera.title);
      const caption = el('span', { class: 'caption' }, el('b', {}, camera.name), title, tags, words);
      const tile = button({ class: 'tile' }, [picture, caption], () => listener.chosen(camera));
      return { camera, picture, polygons, tile, tags, words, lost, pane };
    });
    this.tiles = this.parts;
    const { tearOff, seventies } = listener;
    this.element = el(
      'main',
      { class: 'matrix', 'aria-label': 'All cameras' },
      ...this.parts.map(({ tile }) => tile),
    );
    const across = Math.max(ACROSS, Math.ceil(cameras.length / DOWN));
    const places = group('places', 'Camera places', this.plan.element);
    // The plan replaces the missing tiles if it is larger in their place than below the tiles.
    const left = across * DOWN - cameras.length;
    const among = left >= 2 && left < across;
    if (among) {
      setStyle(places, `--left: ${left}`);
      this.element.append(places);
    }
    setStyle(this.element, `--across: ${across}`);
    const views = group('views', 'Views', this.views);
    if (seventies) {
      this.seventiesKey = button({ class: 'more', title: SEVENTIES }, ['1972'], seventies);
      views.querySelector('h2')?.append(this.seventiesKey);
    }
    if (tearOff) {
      const off = button(
        { class: 'more', title: 'Open all cameras in a secondary window' },
        ['Own window'],
        tearOff,
      );
      views.querySelector('h2')?.append(off);
    }
    this.strip = el(
      'section',
      { class: 'strip-below', 'aria-label': 'Clearance and lamps' },
      ...(among ? [] : [places]),
      this.lentTo.clearance,
      group('lamps-group', 'Caution and warning', this.lentTo.lamps),
      views,
    );
  }

  /** Moves the clearance group of the desk and the lamps into this view, until `close`. */
  open(clearance: HTMLElement | null, lamps: HTMLElement | null): void {
    for (const [node, place] of [
      [clearance, this.lentTo.clearance],
      [lamps, this.lentTo.lamps],
    ] as const) {
      if (!node) continue;
      const here = document.createComment('lent to all cameras');
      node.replaceWith(here);
      place.append(node);
      this.back.push(() => here.replaceWith(node));
    }
  }

  close(): void {
    for (const give of this.back) give();
    this.back = [];
  }

  /** Shows whether the tiles have the look of 1972. */
  setSeventies(on: boolean): void {
    if (this.seventiesKey) setPressed(this.seventiesKey, on);
  }

  /** Writes the subjects that a camera sees, and the monitors that show it. */
  say(index: number, sees: readonly Subject[], tags: readonly string[]): void {
    const part = this.parts[index];
    if (!part) return;
    const { tile, words, tags: shown, camera, pane, picture } = part;
    fitPane(pane, camera, { width: picture.clientWidth, height: picture.clientHeight });
    const text = sees.join(' ');
    setText(words, text);
    if (shown.textContent !== tags.join('')) shown.replaceChildren(...tags.map((tag) => el('em', {}, tag)));
    setClass(tile, 'used', tags.length > 0);
    const label = [
      camera.name,
      camera.title,
      ...tags,
      sees.length > 0 ? `sees ${sees.join(', ')}` : 'sees no subject',
    ];
    setAttribute(tile, 'aria-label', label.join(', '));
  }

  /** Sets the ages of the cameras' pictures; `cure`: what to do if the page does not draw them. */
  setAge(of: (camera: string) => Age, cure: string): void {
    for (const { camera, tile, lost: words } of this.parts) {
      const age = of(camera.name);
      const lost = isStale(age);
      const what = cure || `no frame for ${(age.s - age.set).toFixed(1)} s`;
      setClass(tile, 'is-lost', lost);
      if (lost) setText(words.lastElementChild ?? words, what);
    }
  }

  setAdvice(sentences: readonly string[]): void {
    const lines = [
      ...sentences,
      'Under each picture: what its camera shows of tip, payload, target and minimum clearance (gap).',
    ];
    if (this.views.childElementCount !== lines.length)
      this.views.replaceChildren(...lines.map(() => el('p')));
    lines.forEach((sentence, i) => {
      const line = this.views.children[i];
      if (!line) return;
      setText(line, sentence);
      setAttribute(line, 'title', sentence.startsWith('Sticks') ? TURNED : '');
    });
  }
}

const SEVENTIES = 'Draw all cameras as in 1972: polygons in few greys, with raster lines';
const TURNED = 'Angle by which a picture is turned against the directions of the sticks';

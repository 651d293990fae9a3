/**
 * Overlay of a picture: the minimum clearance as a dashed line with its ends and its value, and the contacts. The scene
 * draws a solid line over the dashes where no body hides the line.
 */

import { el, setAttribute, setClass, setStyle, setText, svg } from '../parts/dom';
import { type Box, clipped, labelPlace, type Point, type Size } from './label-place';

/** A line in the picture [px], and whether it is a caution. */
export interface GapLine {
  readonly a: Point;
  readonly b: Point;
  readonly caution: boolean;
}

/** A contact in the picture. */
export interface Touch {
  readonly at: Point;
  readonly essential: boolean;
}

export interface GapOverlay {
  /** Elements over the picture, in drawing order: lines and marks, then the label. */
  readonly elements: readonly [SVGSVGElement, HTMLElement];
  /** Draws line and contacts, at picture rate; `line` is null if the picture does not show the clearance. */
  show(line: GapLine | null, touches: readonly Touch[], picture: Size): void;
  /** Writes the clearance; `seen`: whether each end of the line is visible. */
  setText(text: string, seen: readonly [boolean, boolean]): void;
}

/** Greatest number of marks for contacts, and their radius [px]. */
const MOST = 8;
const RADIUS = 14;
const ESSENTIAL = 'Essential contact: no alarm';

function around({ x, y }: Point): Box {
  return { left: x - RADIUS, top: y - RADIUS, right: x + RADIUS, bottom: y + RADIUS };
}

export function gapOverlay(taken: (picture: Size) => readonly Box[]): GapOverlay {
  const strokes = ['edge', 'core'].map((name) => svg('line', { class: name }));
  const ends = [0, 1].map(() => svg('circle', { class: 'end', r: '3.5' }));
  const gap = svg('g', { class: 'gap' }, ...strokes, ...ends);
  const marks = Array.from({ length: MOST }, () => {
    const d = 'M-9 0 A9 9 0 1 1 9 0 A9 9 0 1 1 -9 0 M-14 0 H-5 M5 0 H14 M0 -14 V-5 M0 5 V14';
    return svg(
      'g',
      { class: 'touch' },
      svg('title'),
      svg('path', { class: 'edge', d }),
      svg('path', { class: 'core', d }),
    );
  });
  const label = el('p', { class: 'gap-label' });
  const element = svg('svg', { class: 'gaps', 'aria-hidden': 'true' }, gap, ...marks);
  /**
   * Sizes of the label, by number of characters: texts of equal length have the same size because all digits are
   * equally wide. The sizes are stored because each measurement forces a layout.
   */
  const sizes = new Map<number, Size>();
  let room = 0;
  let placeLabel: () => void = () => undefined;
  const sizeOf = (): Size => {
    const letters = label.textContent.length;
    const known = sizes.get(letters);
    if (known) return known;
    const measured = { width: label.offsetWidth, height: label.offsetHeight };
    if (measured.width > 0) sizes.set(letters, measured);
    return measured;
  };
  return {
    elements: [element, label],
    show(line, touches, picture) {
      const seen =
        line && clipped(line.a, line.b, { left: 0, top: 0, right: picture.width, bottom: picture.height });
      setAttribute(gap, 'visibility', seen ? 'visible' : 'hidden');
      label.hidden = !seen;
      marks.forEach((mark, i) => {
        const touch = touches[i];
        setAttribute(mark, 'visibility', touch ? 'visible' : 'hidden');
        if (!touch) return;
        setAttribute(mark, 'transform', `translate(${touch.at.x.toFixed(1)} ${touch.at.y.toFixed(1)})`);
        setClass(mark, 'essential', touch.essential);
        if (mark.firstElementChild) setText(mark.firstElementChild, touch.essential ? ESSENTIAL : 'Contact');
      });
      if (picture.width !== room) sizes.clear();
      room = picture.width;
      if (!line || !seen) return;
      setClass(gap, 'caution', line.caution);
      setClass(label, 'caution', line.caution);
      for (const stroke of strokes) {
        for (const [name, value] of [
          ['x1', line.a.x],
          ['y1', line.a.y],
          ['x2', line.b.x],
          ['y2', line.b.y],
        ] as const)
          setAttribute(stroke, name, value.toFixed(1));
      }
      [line.a, line.b].forEach(({ x, y }, i) => {
        const end = ends[i];
        if (!end) return;
        setAttribute(end, 'cx', x.toFixed(1));
        setAttribute(end, 'cy', y.toFixed(1));
      });
      const marked = touches.map(({ at }) => around(at));
      placeLabel = () => {
        const place = labelPlace(seen, sizeOf(), picture, [...taken(picture), ...marked]);
        setStyle(label, `translate: ${place.x.toFixed(0)}px ${place.y.toFixed(0)}px`);
      };
      placeLabel();
    },
    setText(text, seen) {
      const behind = !seen.includes(true);
      const letters = label.textContent.length;
      setText(label, behind ? `clearance ${text}, hidden` : `clearance ${text}`);
      setClass(label, 'behind', behind);
      ends.forEach((end, i) => {
        setClass(end, 'hidden', !seen[i]);
      });
      // A paused replay draws no further picture, so the label must be placed here.
      if (label.textContent.length !== letters && !label.hidden) placeLabel();
    },
  };
}

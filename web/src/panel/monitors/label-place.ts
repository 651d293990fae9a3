/** Position of a label beside a line in a picture. Lengths are in px; positions start at the picture's top left. */

export interface Point {
  readonly x: number;
  readonly y: number;
}

export interface Box {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** Distance from the line to the label's nearer edge. */
const APART = 12;
/** Distance from the picture's edge. */
const MARGIN = 6;

/** Returns the part of a line that is in a box; null if the line is outside. */
export function clipped(a: Point, b: Point, box: Box): readonly [Point, Point] | null {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  let [from, to] = [0, 1];
  for (const [step, room] of [
    [-dx, a.x - box.left],
    [dx, box.right - a.x],
    [-dy, a.y - box.top],
    [dy, box.bottom - a.y],
  ] as const) {
    if (step === 0) {
      if (room < 0) return null;
    } else if (step < 0) from = Math.max(from, room / step);
    else to = Math.min(to, room / step);
  }
  if (from > to) return null;
  return [
    { x: a.x + from * dx, y: a.y + from * dy },
    { x: a.x + to * dx, y: a.y + to * dy },
  ];
}

/**
 * Returns the top left corner of a label beside the middle of a line. The first choice is the side away from the middle
 * of the picture, because the payload is mostly in the middle. The next choice is any side on which the label fits and
 * covers no box of `taken`. If there is no such side, the label is moved into the picture and off the boxes.
 */
export function labelPlace(
  ends: readonly [Point, Point],
  label: Size,
  picture: Size,
  taken: readonly Box[],
): Point {
  const [a, b] = ends;
  const middle = { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
  const reach = reachOf(a, b, label);
  const beside = middle.y - label.height / 2;
  const over = middle.x - label.width / 2;
  const left = { x: middle.x - reach.x - label.width, y: beside };
  const right = { x: middle.x + reach.x, y: beside };
  const above = { x: over, y: middle.y - reach.y - label.height };
  const below = { x: over, y: middle.y + reach.y };
  const sides = middle.x < picture.width / 2 ? [left, right] : [right, left];
  const ways = middle.y < picture.height / 2 ? [above, below] : [below, above];
  const places = [...sides, ...ways];
  const box = ({ x, y }: Point) => ({ left: x, top: y, right: x + label.width, bottom: y + label.height });
  const free = (place: Point) => !taken.some((each) => overlap(box(place), each));
  const fits = (place: Point) => isInside(box(place), picture) && free(place);
  const inside = places.map((place) => into(place, label, picture));
  const off = taken.flatMap(({ top, bottom }) =>
    inside.flatMap(({ x }) => [
      { x, y: top - label.height },
      { x, y: bottom },
    ]),
  );
  const away = ({ x, y }: Point) =>
    Math.hypot(x + label.width / 2 - middle.x, y + label.height / 2 - middle.y);
  const nearest = off.filter(fits).sort((p, q) => away(p) - away(q))[0];
  return places.find(fits) ?? inside.find(free) ?? nearest ?? inside[0] ?? middle;
}

/**
 * Returns the horizontal and the vertical distance from the middle of a line to the nearer edge of a label. At either
 * distance, the label is clear of the line.
 */
function reachOf(a: Point, b: Point, label: Size): Point {
  const [wide, high] = [Math.abs(a.x - b.x), Math.abs(a.y - b.y)];
  const off = APART * Math.hypot(wide, high);
  return {
    x: Math.min(wide / 2 + APART, (off + (wide * label.height) / 2) / high || Infinity),
    y: Math.min(high / 2 + APART, (off + (high * label.width) / 2) / wide || Infinity),
  };
}

export interface Size {
  readonly width: number;
  readonly height: number;
}

function isInside(box: Box, { width, height }: Size): boolean {
  return (
    box.left >= MARGIN && box.top >= MARGIN && box.right <= width - MARGIN && box.bottom <= height - MARGIN
  );
}

function overlap(a: Box, b: Box): boolean {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/** Returns the position nearest to (x, y) at which the label is inside the picture. */
function into({ x, y }: Point, label: Size, picture: Size): Point {
  const within = (value: number, most: number) => Math.max(MARGIN, Math.min(most - MARGIN, value));
  return { x: within(x, picture.width - label.width), y: within(y, picture.height - label.height) };
}

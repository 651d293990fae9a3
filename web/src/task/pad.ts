/** Drawing of a pad with the standard mapping. Controls that the step needs are outlined; held controls are lit. */

import { isDown } from '../input/active-device';
import type { Device } from '../input/device';
import { setAttribute, setClass, svg } from '../panel/parts/dom';

/** Round parts of the drawing: sources (axes and buttons of the pad), centre, radius. */
const ROUND: readonly (readonly [sources: string, x: number, y: number, r: number])[] = [
  ['a0 a1 b10', 55, 52, 15],
  ['a2 a3 b11', 122, 80, 15],
  ['b0', 147, 65, 6.5],
  ['b1', 160, 52, 6.5],
  ['b2', 134, 52, 6.5],
  ['b3', 147, 39, 6.5],
  ['b8', 87, 46, 4.5],
  ['b9', 113, 46, 4.5],
];
/** Rectangular parts of the drawing: sources (buttons of the pad), left, top, width, height. */
const SQUARE: readonly (readonly [sources: string, x: number, y: number, w: number, h: number])[] = [
  ['b6', 36, 3, 36, 10],
  ['b7', 128, 3, 36, 10],
  ['b4', 32, 16, 44, 8],
  ['b5', 124, 16, 44, 8],
  ['b12', 73.5, 67, 9, 9],
  ['b13', 73.5, 85, 9, 9],
  ['b14', 64.5, 76, 9, 9],
  ['b15', 82.5, 76, 9, 9],
];
const BODY =
  'M40 27 H160 C180 27 187 52 192 84 C196 112 178 120 164 106 L150 96 H50 L36 106 C22 120 4 112 8 84 C13 52 20 27 40 27 Z';
/** Shift of a drawn stick at full deflection. */
const LEAN = 7;

export function padDrawing() {
  const parts = [
    ...ROUND.map(([sources, x, y, r]) => part(sources, svg('circle', circle(x, y, r)))),
    ...SQUARE.map(([sources, x, y, width, height]) =>
      part(sources, svg('rect', { ...texts({ x, y, width, height }), rx: '2.5' })),
    ),
  ];
  const tops = ROUND.slice(0, 2).map(([, x, y]) => svg('circle', { class: 'top', ...circle(x, y, 8) }));
  const element = svg(
    'svg',
    { class: 'pad-drawing', viewBox: '0 0 200 122', 'aria-hidden': 'true' },
    svg('path', { class: 'body', d: BODY }),
    ...parts.map((each) => each.element),
    ...tops,
  );
  return {
    element,
    /** `wanted`: sources of the controls that this step needs. */
    set(device: Device, wanted: ReadonlySet<string>) {
      for (const each of parts) {
        setClass(
          each.element,
          'wanted',
          each.sources.some((source) => wanted.has(source)),
        );
        setClass(
          each.element,
          'held',
          each.sources.some((source) => isHeld(device, source)),
        );
      }
      tops.forEach((top, i) => {
        const [x, y] = [0, 1].map((axis) => (device.reading?.axes[2 * i + axis] ?? 0) * LEAN);
        setAttribute(top, 'transform', `translate(${x?.toFixed(1)} ${y?.toFixed(1)})`);
      });
    },
  };
}

function part(sources: string, element: SVGElement) {
  setAttribute(element, 'class', 'part');
  return { element, sources: sources.split(' ') };
}

function isHeld(device: Device, source: string): boolean {
  return isDown(device, source, 1) || (source.startsWith('a') && isDown(device, source, -1));
}

function circle(x: number, y: number, r: number) {
  return texts({ cx: x, cy: y, r });
}

function texts(numbers: Readonly<Record<string, number>>): Record<string, string> {
  return Object.fromEntries(Object.entries(numbers).map(([name, value]) => [name, String(value)]));
}

import { CanvasTexture, LinearMipmapNearestFilter, NoColorSpace, RepeatWrapping, type Texture } from 'three';
import { present } from '../basics/assert';
import type { Quality } from './drawn';

/** Grey pattern that dims the colour of a surface; `plain` is no pattern. */
export type Pattern =
  | 'plain'
  | 'quilt'
  | 'liner'
  | 'seams'
  | 'tiles'
  | 'panel'
  | 'crinkle'
  | 'cells'
  | 'scuffed';

type Painter = (pen: CanvasRenderingContext2D, size: number, random: () => number) => void;

/** Width and height of one repeat on the surface [m], and the function that paints it. */
const PATTERNS: Record<Exclude<Pattern, 'plain'>, { repeat: [number, number]; paint: Painter }> = {
  quilt: { repeat: [2, 2], paint: (pen, size, random) => stitched(pen, size, random, 6, 0.4) },
  liner: { repeat: [2.4, 2.4], paint: (pen, size, random) => stitched(pen, size, random, 4, 0.5) },
  seams: { repeat: [2.8, 1.2], paint: wrapped },
  tiles: { repeat: [2.4, 2.4], paint: tiled },
  panel: { repeat: [2.24, 1], paint: panelled },
  crinkle: { repeat: [1.5, 1.5], paint: crinkled },
  cells: { repeat: [0.8, 0.8], paint: celled },
  scuffed: { repeat: [1.2, 1.2], paint: scuffed },
};

/** Make the texture of a pattern, identical in every run. The low profile reads one mipmap level for each pixel. */
export function patternTexture(pattern: Exclude<Pattern, 'plain'>, quality: Quality): Texture {
  const { repeat, paint } = PATTERNS[pattern];
  const full = quality === 'full';
  const texture = repeated(full ? 512 : 256, paint, repeat);
  if (full) texture.anisotropy = 8;
  else texture.minFilter = LinearMipmapNearestFilter;
  return texture;
}

/** Make the relief of a crumpled blanket; middle grey is zero height. */
export function crumpleTexture(size: number): Texture {
  return repeated(size, crumpled, [1.2, 1.2]);
}

function repeated(size: number, paint: Painter, [width, height]: readonly [number, number]): Texture {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = size;
  paint(present(canvas.getContext('2d'), 'a canvas to paint on'), size, generator(20));
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = NoColorSpace;
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.repeat.set(1 / width, 1 / height);
  return texture;
}

/** Return a generator of random numbers in [0, 1), equal for equal seeds (Numerical Recipes' linear congruence). */
function generator(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

const grey = (level: number, alpha = 1) => {
  const value = Math.round(255 * level);
  return `rgba(${value}, ${value}, ${value}, ${alpha})`;
};

/**
 * Paint faint stains of all sizes. A stain that crosses an edge continues at the opposite edge, so that repeats join
 * without a seam.
 */
function stain(pen: CanvasRenderingContext2D, size: number, random: () => number, count: number): void {
  for (let i = 0; i < count; i++) {
    pen.fillStyle = grey(random() < 0.5 ? 0 : 1, 0.05 * random());
    const [x, y, w] = [random() * size, random() * size, size * (0.005 + 0.05 * random() ** 2)];
    const h = w * (0.3 + random());
    for (const dx of [0, -size]) for (const dy of [0, -size]) pen.fillRect(x + dx, y + dy, w, h);
  }
}

/** Paint a blanket of n x n panels with stitched borders, each panel in a different shade. */
function stitched(
  pen: CanvasRenderingContext2D,
  size: number,
  random: () => number,
  n: number,
  depth: number,
): void {
  const cell = size / n;
  for (let i = 0; i < n; i++) {
    for (let j = 0; j < n; j++) {
      pen.fillStyle = grey(1 - 0.1 * random());
      pen.fillRect(i * cell, j * cell, cell, cell);
    }
  }
  stain(pen, size, random, 900);
  pen.fillStyle = grey(0.2, depth);
  const line = Math.max(1, size / 200);
  for (let i = 0; i < n; i++) {
    pen.fillRect(i * cell, 0, line, size);
    pen.fillRect(0, i * cell, size, line);
  }
}

/** Paint the wrapping of a boom: four seams round the boom, each with a row of ties, and one seam along the boom. */
function wrapped(pen: CanvasRenderingContext2D, size: number, random: () => number): void {
  pen.fillStyle = grey(0.97);
  pen.fillRect(0, 0, size, size);
  stain(pen, size, random, 700);
  for (let i = 0; i < 4; i++) {
    const x = (i * size) / 4;
    pen.fillStyle = grey(0.25, 0.6);
    pen.fillRect(x, 0, size / 150, size);
    pen.fillStyle = grey(1, 0.6);
    pen.fillRect(x + size / 150, 0, size / 120, size);
    pen.fillStyle = grey(0.3, 0.55);
    for (let k = 0; k < 10; k++) pen.fillRect(x + size / 45, ((k + 0.3) * size) / 10, size / 130, size / 90);
  }
  pen.fillStyle = grey(0.25, 0.5);
  pen.fillRect(0, 0.1 * size, size, size / 100);
}

/** Paint 16 x 16 tiles in different shades, with dark gaps. */
function tiled(pen: CanvasRenderingContext2D, size: number, random: () => number): void {
  pen.fillStyle = grey(0.35);
  pen.fillRect(0, 0, size, size);
  const cell = size / 16;
  for (let i = 0; i < 16; i++) {
    for (let j = 0; j < 16; j++) {
      pen.fillStyle = grey(0.65 + 0.35 * random());
      pen.fillRect(i * cell + cell / 24, j * cell + cell / 24, cell * 0.92, cell * 0.92);
    }
  }
}

/** Paint the tubes of a radiator, and a joint at each quarter. */
function panelled(pen: CanvasRenderingContext2D, size: number, random: () => number): void {
  pen.fillStyle = grey(0.96);
  pen.fillRect(0, 0, size, size);
  stain(pen, size, random, 200);
  for (let i = 0; i < 32; i++) {
    pen.fillStyle = i % 2 ? grey(0.2, 0.12) : grey(1, 0.12);
    pen.fillRect(0, (i * size) / 32, size, size / 64);
  }
  pen.fillStyle = grey(0.15, 0.35);
  for (let i = 0; i < 4; i++) pen.fillRect((i * size) / 4, 0, size / 170, size);
}

/** Paint light and dark creases in all directions. */
function crumpled(pen: CanvasRenderingContext2D, size: number, random: () => number): void {
  pen.fillStyle = grey(0.5);
  pen.fillRect(0, 0, size, size);
  for (let i = 0; i < 420; i++) {
    const [x, y, angle] = [random() * size, random() * size, random() * 2 * Math.PI];
    const reach = size * (0.04 + 0.13 * random());
    const [ex, ey] = [x + reach * Math.cos(angle), y + reach * Math.sin(angle)];
    const [mx, my] = [(x + ex) / 2 + 0.03 * size * random(), (y + ey) / 2 + 0.03 * size * random()];
    pen.strokeStyle = grey(random() < 0.5 ? 0 : 1, 0.16);
    pen.lineWidth = (size / 512) * (1 + 5 * random());
    for (const dx of [0, -size]) {
      for (const dy of [0, -size]) {
        pen.beginPath();
        pen.moveTo(x + dx, y + dy);
        pen.quadraticCurveTo(mx + dx, my + dy, ex + dx, ey + dy);
        pen.stroke();
      }
    }
  }
}

/** Paint foil: facets between random creases, each as bright as what it reflects, and stitched seams. */
function crinkled(pen: CanvasRenderingContext2D, size: number, random: () => number): void {
  const n = 30;
  const cell = size / n;
  const nodes = Array.from({ length: n * n }, () => [random() - 0.5, random() - 0.5] as const);
  const node = (i: number, j: number): readonly [number, number] => {
    const [dx, dy] = nodes[(i % n) + n * (j % n)] ?? [0, 0];
    return [(i + 0.9 * dx) * cell, (j + 0.9 * dy) * cell];
  };
  for (let i = 0; i < n; i++) {
    for (let j = 0; j < n; j++) {
      const [a, b, c, d] = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)];
      for (const corners of random() < 0.5
        ? [[a, b, c] as const, [a, c, d] as const]
        : [[a, b, d] as const, [b, c, d] as const]) {
        const [[u0, v0], [u1, v1]] = [corners[0], corners[Math.floor(1 + 2 * random())] ?? corners[1]];
        const levels = [0.55 + 0.35 * random(), 0.6 + 0.4 * random() ** 2] as const;
        for (const x of [0, -size]) {
          for (const y of [0, -size]) {
            const slope = pen.createLinearGradient(u0 + x, v0 + y, u1 + x, v1 + y);
            levels.forEach((level, k) => {
              slope.addColorStop(k, grey(level));
            });
            pen.fillStyle = pen.strokeStyle = slope;
            pen.beginPath();
            for (const [u, v] of corners) pen.lineTo(u + x, v + y);
            pen.closePath();
            pen.fill();
            pen.stroke();
          }
        }
      }
    }
  }
  pen.fillStyle = grey(0.15, 0.45);
  for (let i = 0; i < 2; i++) {
    pen.fillRect((i * size) / 2, 0, Math.max(1, size / 150), size);
    pen.fillRect(0, (i * size) / 2, size, Math.max(1, size / 150));
  }
}

/** Paint 8 x 8 solar cells with bright bars between strings. */
function celled(pen: CanvasRenderingContext2D, size: number, random: () => number): void {
  pen.fillStyle = grey(0.8);
  pen.fillRect(0, 0, size, size);
  const cell = size / 8;
  for (let i = 0; i < 8; i++) {
    for (let j = 0; j < 8; j++) {
      pen.fillStyle = grey(0.08 + 0.12 * random());
      pen.fillRect(i * cell + cell / 20, j * cell + cell / 20, cell * 0.92, cell * 0.92);
    }
  }
  pen.fillStyle = grey(0.5, 0.35);
  for (let i = 0; i < 24; i++) pen.fillRect(0, (i * size) / 24, size, size / 250);
}

/** Paint white paint with dark scratches along it, worn places and smears. */
function scuffed(pen: CanvasRenderingContext2D, size: number, random: () => number): void {
  pen.fillStyle = grey(0.95);
  pen.fillRect(0, 0, size, size);
  stain(pen, size, random, 500);
  for (let i = 0; i < 90; i++) {
    pen.fillStyle = grey(random() < 0.7 ? 0.1 : 1, 0.15 + 0.35 * random());
    const [x, y, w] = [random() * size, random() * size, size * (0.01 + 0.12 * random() ** 2)];
    for (const dx of [0, -size]) pen.fillRect(x + dx, y, w, Math.max(1, size * 0.004 * random()));
  }
  for (let i = 0; i < 14; i++) {
    pen.fillStyle = grey(0.25, 0.1 + 0.15 * random());
    const [x, y, w] = [random() * size, random() * size, size * (0.02 + 0.05 * random())];
    for (const dx of [0, -size])
      for (const dy of [0, -size]) pen.fillRect(x + dx, y + dy, w, w * (0.2 + 0.5 * random()));
  }
}

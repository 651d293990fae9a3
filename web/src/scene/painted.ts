import {
  BufferGeometry,
  CanvasTexture,
  Float32BufferAttribute,
  LinearMipmapNearestFilter,
  MirroredRepeatWrapping,
  NoColorSpace,
  type Texture,
} from 'three';
import { present } from '../basics/assert';

/** How often the texture of the clouds repeats from the nadir to the limb. */
const REPEATS = 2.4;

/** Angles from the limb [rad] and colours of the cap's rings, from the nadir outwards. The last ring is black. */
const RINGS: readonly (readonly [number, readonly [number, number, number]])[] = [
  [Number.NEGATIVE_INFINITY, [0.16, 0.31, 0.52]],
  [-0.75, [0.2, 0.36, 0.58]],
  [-0.35, [0.3, 0.47, 0.7]],
  [-0.12, [0.42, 0.6, 0.82]],
  [-0.03, [0.56, 0.72, 0.92]],
  [0, [0.72, 0.84, 0.98]],
  [0.006, [0.4, 0.6, 0.92]],
  [0.016, [0.14, 0.26, 0.5]],
  [0.035, [0, 0, 0]],
];

/** Make the Earth as a cap of the sky around +z; `limb` is the angle from the nadir to the limb [rad]. */
export function paintedCap(limb: number): BufferGeometry {
  const round = 48;
  const [positions, colours, uvs, indices] = [[], [], [], []] as [number[], number[], number[], number[]];
  RINGS.forEach(([fromLimb, colour], i) => {
    const angle = Math.max(0, limb + fromLimb);
    for (let k = 0; k <= round; k++) {
      const [c, s] = [Math.cos((2 * Math.PI * k) / round), Math.sin((2 * Math.PI * k) / round)];
      positions.push(c * Math.sin(angle), s * Math.sin(angle), Math.cos(angle));
      const reach = REPEATS * Math.min(1, angle / limb);
      uvs.push(0.5 + c * reach, 0.5 + s * reach);
      colours.push(...colour);
      const b = i * (round + 1) + k;
      const a = b - round - 1;
      if (i > 0 && k < round) indices.push(a, a + 1, b, b, a + 1, b + 1);
    }
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
  geometry.setAttribute('color', new Float32BufferAttribute(colours, 3));
  geometry.setAttribute('uv', new Float32BufferAttribute(uvs, 2));
  geometry.setIndex(indices);
  return geometry;
}

/** Make a texture of grey clouds from smooth noise: 128 x 128 pixels, which repeat as mirror images. */
export function paintedClouds(): Texture {
  const size = 128;
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = size;
  const pen = present(canvas.getContext('2d'), 'a canvas to paint on');
  const picture = pen.createImageData(size, size);
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      const weather = softNoise(x, y, 48);
      const wisps = softNoise(x + 12 * weather, y, 14) + 0.6 * softNoise(x, y, 6) + 0.4 * softNoise(x, y, 3);
      const cloud = Math.max(0, Math.min(1, 3.2 * (0.5 * weather + 0.25 * wisps - 0.42)));
      picture.data.fill(170 + 85 * cloud, 4 * (y * size + x), 4 * (y * size + x) + 3);
      picture.data[4 * (y * size + x) + 3] = 255;
    }
  }
  pen.putImageData(picture, 0, 0);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = NoColorSpace;
  texture.wrapS = texture.wrapT = MirroredRepeatWrapping;
  texture.minFilter = LinearMipmapNearestFilter;
  return texture;
}

/** Return noise in [0, 1]: random values on a lattice with this step [pixels], interpolated smoothly. */
function softNoise(x: number, y: number, step: number): number {
  const [i, j] = [Math.floor(x / step), Math.floor(y / step)];
  const ease = (t: number) => t * t * (3 - 2 * t);
  const [u, v] = [ease(x / step - i), ease(y / step - j)];
  const at = (a: number, b: number) => {
    const mixed = Math.imul((i + a) ^ Math.imul(j + b, 0x27d4eb2d) ^ (step << 16), 0x85ebca6b);
    return ((mixed ^ (mixed >>> 15)) >>> 0) / 2 ** 32;
  };
  const [low, high] = [at(0, 0) * (1 - u) + at(1, 0) * u, at(0, 1) * (1 - u) + at(1, 1) * u];
  return low * (1 - v) + high * v;
}

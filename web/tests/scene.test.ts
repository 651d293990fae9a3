import { BoxGeometry, Matrix4, Raycaster, type ShaderMaterial, Vector3 } from 'three';
import { expect, test } from 'vitest';
import type { BodyInfo, Camera, Group, Shape } from '../src/link/protocol';
import { Body } from '../src/scene/bodies';
import { Cameras } from '../src/scene/cameras';
import { ASPECT } from '../src/scene/drawn';
import { LambertLight } from '../src/scene/lambert';
import { Materials } from '../src/scene/materials';
import { Surface } from '../src/scene/surface';
import { bay } from './camera-values';
import { surfaceOf, volume } from './surfaces';

const placed = { position: [0, 0, 0], rotation: [0, 0, 0] } as const;
const solid = { ...placed, material: 'metal' } as const;
const turn = { start: 0, sweep: 2 * Math.PI } as const;
const section = { half_width: 1, top: 1, middle: 0, bottom: -1, exponents: [2, 2] } as const;

const cases: readonly (readonly [string, Exclude<Shape, Group>, number])[] = [
  ['box', { ...solid, kind: 'box', size: [1, 2, 3] }, 6],
  ...(['x', 'y', 'z'] as const).map((axis) => {
    const shape = { ...solid, kind: 'cylinder', axis, length: 2, radius: 0.5, radius_end: null } as const;
    return [`cylinder along ${axis}`, shape, Math.PI / 2] as const;
  }),
  ['cone', { ...solid, kind: 'cylinder', axis: 'x', length: 3, radius: 1, radius_end: 0.5 }, 1.75 * Math.PI],
  [
    'tube',
    { ...solid, ...turn, kind: 'shell', axis: 'z', length: 1, radius: 1, radius_end: null, thickness: 0.5 },
    0.75 * Math.PI,
  ],
  [
    'quarter of a disc',
    {
      ...solid,
      kind: 'shell',
      axis: 'y',
      length: 1,
      radius: 1,
      radius_end: null,
      thickness: 1,
      start: 1,
      sweep: Math.PI / 2,
    },
    Math.PI / 4,
  ],
  ['ring', { ...solid, ...turn, kind: 'ring', axis: 'x', radius: 1, bar: 0.1 }, 0.02 * Math.PI ** 2],
  ['half ring', { ...solid, kind: 'ring', axis: 'x', radius: 1, bar: 0.1, start: 2, sweep: Math.PI }, 0.0987],
  [
    'wedge',
    {
      ...solid,
      kind: 'hexahedron',
      vertices: [-0.5, 0.5].flatMap((y) =>
        [0, 1.8].flatMap((x) => [0, 1].map((z) => [x, y * (1 + 0.5 * z), z] as const)),
      ),
    },
    2.25,
  ],
  ['sphere', { ...solid, kind: 'sphere', radius: 1 }, (4 / 3) * Math.PI],
  ...(['x', 'y', 'z'] as const).map((normal) => {
    const outline = [
      [0, 0],
      [2, 0],
      [0, 1],
    ] as const;
    const shape = { ...solid, kind: 'plate', normal, outline, thickness: 0.5, bevel: 0 } as const;
    return [`plate across ${normal}`, shape, 0.5] as const;
  }),
  [
    'loft',
    {
      ...solid,
      kind: 'loft',
      sections: [
        { ...section, x: 0 },
        { ...section, x: 2 },
      ],
    },
    2 * Math.PI,
  ],
];

test.each(cases)('a %s is closed, faces outwards and has its volume', (_, shape, expected) => {
  const found = volume(surfaceOf(shape, 'full'));
  expect(found / expected).toBeGreaterThan(0.95);
  expect(found / expected).toBeLessThan(1.001);
});

test.each(cases)('the normals of a %s are unit vectors on the outer side', (_, shape) => {
  const { positions, normals, indices } = surfaceOf(shape, 'full');
  const at = (list: number[], i: number) => new Vector3().fromArray(list, 3 * (indices[i] ?? 0));
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [at(positions, i), at(positions, i + 1), at(positions, i + 2)];
    const face = b.sub(a).cross(c.sub(a));
    if (face.length() < 1e-9) continue;
    for (const k of [0, 1, 2]) {
      expect(at(normals, i + k).length()).toBeCloseTo(1, 6);
      expect(face.normalize().dot(at(normals, i + k))).toBeGreaterThan(0.5);
    }
  }
});

test.each(cases.filter(([name]) => !/cone|ring|sphere|plate|loft/.test(name)))(
  'patterns have their own size on a %s',
  (_, shape) => {
    const { positions, uvs, indices } = surfaceOf(shape, 'full');
    const corner = (i: number) => new Vector3().fromArray(positions, 3 * (indices[i] ?? 0));
    const painted = (i: number) => new Vector3().fromArray(uvs, 2 * (indices[i] ?? 0)).setZ(0);
    for (let i = 0; i < indices.length; i += 3) {
      const [area, share] = [corner, painted].map((at) => {
        const a = at(i);
        return at(i + 1)
          .sub(a)
          .cross(at(i + 2).sub(a))
          .length();
      }) as [number, number];
      // The texture's coordinates follow the outer circle of a wall, the triangles are within it.
      expect(Math.abs(share / area - 1)).toBeLessThan(0.01);
    }
  },
);

test('a mirrored surface still faces outwards', () => {
  const mirrored = new Surface();
  mirrored.append(new BoxGeometry(1, 1, 1), new Matrix4().makeScale(1, -1, 1).setPosition(5, 0, 0));
  expect(volume(mirrored)).toBeCloseTo(1);
});

const box = { ...solid, kind: 'box', size: [0.2, 0.2, 0.2] } as const;

function bodyOf(shapes: readonly Shape[]): Body {
  const info: BodyInfo = { name: 'thing', shapes, details: [] };
  return new Body(info, new Materials('low', new LambertLight(0)), 'low');
}

test('a group repeats its shapes at equal steps and mirrors them from port to starboard', () => {
  const group: Group = {
    kind: 'group',
    position: [0, 2, 0],
    rotation: [0, 0, 0],
    shapes: [box],
    count: 3,
    step: [1, 0, 0],
    turn: [0, 0, 0],
    mirror: true,
  };
  const found = bodyOf([group]).box();
  expect(found.min.toArray()).toEqual([-0.1, -2.1, -0.1].map((x) => expect.closeTo(x, 5)));
  expect(found.max.toArray()).toEqual([2.1, 2.1, 0.1].map((x) => expect.closeTo(x, 5)));
});

test('a rotation is roll, then pitch, then yaw about fixed axes', () => {
  const quarter = Math.PI / 2;
  // Roll takes z to -y; the yaw then takes -y to x.
  const rod = { ...box, size: [0.2, 0.2, 6], rotation: [quarter, 0, quarter] } as const;
  expect(bodyOf([rod]).box().max.x).toBeCloseTo(3, 5);
});

const camera: Camera = {
  ...bay,
  name: 'X',
  body: 'thing',
  position: [0, 0, 1],
  boresight: [2, 0, 0],
  field_of_view: Math.PI / 2,
  drive: null,
};

function cameraAt(pose: readonly number[]): Cameras {
  const body = bodyOf([box]);
  body.setPose(pose, 0);
  return new Cameras([camera], [body]);
}

test('the field of view is the horizontal one of pictures that are not low', () => {
  const cameras = cameraAt([0, 0, 0, 1, 0, 0, 0]);
  for (const aspect of [1 / 2, 4 / 3, ASPECT]) {
    // The camera looks aft with its upper side up. Port is then on the right; y is starboard.
    expect(cameras.project('X', aspect, [10, -9.99, 1])).toMatchObject({
      x: expect.closeTo(1, 2),
      visible: true,
    });
    expect(cameras.project('X', aspect, [10, -10.01, 1]).visible).toBe(false);
    expect(cameras.project('X', aspect, [10, 0, 1 + 10 / aspect]).y).toBeCloseTo(0, 5);
  }
});

test.each([2, 3.7, 8])(
  'a picture %d times as wide as high shows what a higher one does, and more at its sides',
  (aspect) => {
    const cameras = cameraAt([0, 0, 0, 1, 0, 0, 0]);
    for (const [y, z] of [
      [-9.9, 1],
      [9.9, 1 + 9.9 / ASPECT],
      [0, 1 - 9.9 / ASPECT],
    ] as const) {
      const [low, high] = [aspect, ASPECT].map((shape) => cameras.project('X', shape, [10, y, z]));
      expect(low?.visible).toBe(true);
      expect(low?.y).toBeCloseTo(high?.y ?? 0, 9);
      expect(((low?.x ?? 0) - 0.5) * aspect).toBeCloseTo(((high?.x ?? 0) - 0.5) * ASPECT, 9);
    }
  },
);

test('a point behind a camera is not visible', () => {
  expect(cameraAt([0, 0, 0, 1, 0, 0, 0]).project('X', 1, [-10, 0, 1]).visible).toBe(false);
});

test('a line is projected only as far as it is in front of the camera', () => {
  const cameras = cameraAt([0, 0, 0, 1, 0, 0, 0]);
  const whole = cameras.segment('X', 1, [10, -5, 1], [10, 5, 1]);
  expect(whole?.map(({ x }) => x)).toEqual([0.75, 0.25].map((x) => expect.closeTo(x, 5)));
  expect(whole?.map(({ y }) => y)).toEqual([0.5, 0.5].map((y) => expect.closeTo(y, 5)));
  expect(cameras.segment('X', 1, [-10, 0, 1], [-5, 3, 1])).toBeNull();
  for (const [a, b] of [
    [[10, -5, 1] as const, [-10, -5, 1] as const],
    [[-10, -5, 1] as const, [10, -5, 1] as const],
  ] as const) {
    const cut = cameras.segment('X', 1, a, b);
    const [near, far] = a[0] < 0 ? [cut?.[0], cut?.[1]] : [cut?.[1], cut?.[0]];
    expect(far?.x).toBeCloseTo(0.75, 5);
    expect(near?.x).toBeGreaterThan(10);
  }
});

test('a camera moves with its body', () => {
  const half = Math.SQRT1_2;
  const cameras = cameraAt([5, 0, 0, half, 0, 0, half]); // yawed 90 deg: looks along y
  expect(cameras.project('X', 1, [5, 7, 1])).toMatchObject({
    x: expect.closeTo(0.5, 5),
    y: expect.closeTo(0.5, 5),
  });
  const [x, y, z] = cameras.directions('X', [1, 0, 0, 0]);
  expect(x).toEqual([1, 0, 0].map((c) => expect.closeTo(c, 5)));
  expect(y).toEqual([0, 0, -1].map((c) => expect.closeTo(c, 5)));
  expect(z).toEqual([0, 1, 0].map((c) => expect.closeTo(c, 5)));
});

test('details are drawn, but neither enlarge the box of a body nor belong to what hides others', () => {
  const far = { ...box, position: [5, 0, 0] } as const;
  const info: BodyInfo = { name: 'thing', shapes: [box], details: [far] };
  const body = new Body(info, new Materials('low', new LambertLight(0)), 'low');
  expect(body.drawn.triangles).toBe(24);
  expect(body.box().max.x).toBeCloseTo(0.1, 5);
  expect(body.plain.map(({ geometry }) => geometry.index?.count)).toEqual([36]);
  const ray = new Raycaster(new Vector3(5, 0, 9), new Vector3(0, 0, -1));
  expect(ray.intersectObjects(body.plain)).toEqual([]);
  expect(ray.intersectObjects(body.group.children)).not.toEqual([]);
});

test('a body of details alone has an empty box', () => {
  const info: BodyInfo = { name: 'thing', shapes: [], details: [box] };
  const body = new Body(info, new Materials('low', new LambertLight(0)), 'low');
  expect(body.box().isEmpty()).toBe(true);
  expect(body.plain).toEqual([]);
  expect(body.drawn.triangles).toBe(12);
});

test('what hides others moves with its body', () => {
  const body = bodyOf([box]);
  body.setPose([7, 0, 0, 1, 0, 0, 0], 0);
  const ray = new Raycaster(new Vector3(7, 0, 9), new Vector3(0, 0, -1));
  expect(ray.intersectObjects(body.plain)).not.toEqual([]);
});

test('the details of a boom bend with it', () => {
  const info: BodyInfo = { name: 'boom', shapes: [box], details: [{ ...box, size: [6, 0.1, 0.1] }] };
  const body = new Body(info, new Materials('low', new LambertLight(0)), 'low', [6, 0, 0]);
  const across = body.mesh('plain')?.geometry.getAttribute('position');
  const before = across?.array.slice();
  body.bend([6, 0, 0], { displacement: [0, 0.5, 0], rotation: [0, 0, 0.1] });
  expect(across?.array).not.toEqual(before);
});

test('the shadow of the hand falls on a material only in the low profile, and only where it is asked for', () => {
  const materials = new Materials('low', new LambertLight(0));
  const [plain, shaded] = [materials.material('plain'), materials.material('plain', true)];
  expect(plain).not.toBe(shaded);
  expect((shaded as ShaderMaterial).defines).toHaveProperty('SHADED');
  expect((plain as ShaderMaterial).defines).not.toHaveProperty('SHADED');
});

import { Color, Matrix4, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import type { BodyInfo, Vec3, Welcome } from '../src/link/protocol';
import { bendPoints, motionOf, times } from '../src/scene/bend';
import { Bending, EXAGGERATION } from '../src/scene/bending';
import { Body } from '../src/scene/bodies';
import { LambertLight } from '../src/scene/lambert';
import { Materials } from '../src/scene/materials';
import { refine } from '../src/scene/refine';
import { surfaceOf, volume } from './surfaces';

const END: Vec3 = [6.4, 0, 0.15];
const bend = { displacement: [0.001, 0.02, -0.05], rotation: [0.01, 0.012, 0.005] } as const;

function bent(points: readonly Vec3[], by: Parameters<typeof times>[0] = bend): Vec3[] {
  const out = new Float32Array(3 * points.length);
  bendPoints(points.flat(), out, END, by);
  return points.map((_, i) => [out[3 * i] ?? 0, out[3 * i + 1] ?? 0, out[3 * i + 2] ?? 0]);
}

const close = (found: readonly number[], expected: readonly number[], within: number) => {
  found.forEach((value, i) => {
    expect(Math.abs(value - (expected[i] ?? 0))).toBeLessThan(within);
  });
};

describe('a bent boom', () => {
  test('is clamped at its beginning, and ends where the simulation says', () => {
    const [start = [], before = [], end = []] = bent([[0, 0, 0], [-0.3, 0.2, 0.1], END]);
    close(start, [0, 0, 0], 1e-6);
    close(before, [-0.3, 0.2, 0.1], 1e-6);
    close(
      end,
      END.map((each, i) => each + (bend.displacement[i] ?? 0)),
      1e-6,
    );
  });

  test('takes what is fixed to its end along as a rigid body', () => {
    const beyond: Vec3 = [6.6, 0.2, 0.3];
    const motion = motionOf(bend, END);
    const expected = new Vector3(...beyond).applyMatrix4(motion);
    const [found = []] = bent([beyond]);
    close(found, expected.toArray(), 1e-4); // the drawing is linear in the small angles
  });

  test('has the shape of a cantilever under a force at its end', () => {
    // Euler-Bernoulli: y(s) = F s^2 (3 L - s) / 6EI; at the end, y = F L^3 / 3EI and the slope is 3 y / 2L
    const length = Math.hypot(...END);
    const along = new Vector3(...END).divideScalar(length);
    const cantilever = {
      displacement: [0, 0.06, 0],
      rotation: new Vector3()
        .crossVectors(along, new Vector3(0, 1, 0))
        .multiplyScalar(0.09 / length)
        .toArray(),
    } as const;
    for (const s of [0.25, 0.5, 0.75]) {
      const point = along.clone().multiplyScalar(s * length);
      const [found = [0, 0, 0]] = bent([point.toArray() as Vec3], cantilever as never);
      expect(found[1]).toBeCloseTo(0.03 * s * s * (3 - s), 6);
    }
  });
});

test('a refined surface has the same volume, no long edges, and no gaps', () => {
  const shape = {
    kind: 'cylinder',
    material: 'boom',
    axis: 'x',
    length: 5.3,
    radius: 0.19,
    radius_end: null,
  } as const;
  const surface = surfaceOf({ ...shape, position: [0, 0, 0], rotation: [0, 0, 0] } as never, 'low');
  const [before, count] = [volume(surface), surface.indices.length];
  const colours = surface.positions.map(() => 0.5);
  refine(surface, colours, new Vector3(1, 0, 0));
  expect(surface.indices.length).toBeGreaterThan(4 * count);
  expect(volume(surface)).toBeCloseTo(before, 9);
  expect(colours.length).toBe(surface.positions.length);
  const places = new Map<string, number>();
  for (let i = 0; i < surface.indices.length; i++) {
    const [a, b] = [i, i % 3 === 2 ? i - 2 : i + 1].map((k) =>
      new Vector3().fromArray(surface.positions, 3 * (surface.indices[k] ?? 0)),
    );
    if (!a || !b) continue;
    expect(Math.abs(a.x - b.x)).toBeLessThanOrEqual(0.8);
    const name = (p: Vector3, q: Vector3) =>
      [p, q].map((v) => v.toArray().map((each) => Math.round(1e6 * each))).join();
    places.set(name(a, b), (places.get(name(a, b)) ?? 0) + 1);
    places.set(name(b, a), (places.get(name(b, a)) ?? 0) - 1);
  }
  // every edge is passed once in each direction, so that the surface is closed
  expect([...places.values()].every((sum) => sum === 0)).toBe(true);
});

describe('the drawn arm', () => {
  const materials = new Materials('low', new LambertLight(0));
  const box = { kind: 'box', material: 'metal', size: [1, 1, 1], position: [0, 0, 0], rotation: [0, 0, 0] };
  const info = (name: string): BodyInfo => ({ name, shapes: [box], details: [] }) as never;
  const welcome = {
    flexures: [
      { body: 1, end: [0, 0, 0] },
      { body: 2, end: END },
    ],
    ghost: [1, 2, 3, 4],
    work: { cargo: ['module'] },
  } as unknown as Welcome;
  const base = { displacement: [0, 0, 0], rotation: [0.002, 0.001, -0.003] } as const;
  const straight = [
    new Matrix4(),
    new Matrix4(),
    new Matrix4().makeTranslation(0, 0, 1),
    new Matrix4().makeTranslation(6.4, 0, 1.15),
  ];

  /** Poses of all bodies with bends multiplied by `factor`; the payload is in the grasp. */
  function placed(factor: number): Matrix4[] {
    const [root = new Matrix4(), foot = root, boom = root, hand = root] = straight;
    const first = motionOf(times(base, factor), [0, 0, 0]);
    const boomAt = first.clone().multiply(boom);
    const behind = motionOf(times(bend, factor), END);
    const relative = boom.clone().invert().multiply(hand);
    const handAt = boomAt.clone().multiply(behind).multiply(relative);
    return [root, foot, boomAt, handAt, handAt.clone().multiply(new Matrix4().makeTranslation(1, 0, 0))];
  }

  function drawn(factor: number, held: readonly string[]): Matrix4[] {
    const bodies = ['orbiter', 'base', 'boom', 'hand', 'module'].map(
      (name) => new Body(info(name), materials, 'low'),
    );
    placed(1).forEach((pose, i) => {
      bodies[i]?.group.matrix.copy(pose);
    });
    new Bending(welcome, bodies).show([base, bend], factor, held);
    return bodies.map(({ group }) => group.matrix.clone());
  }

  test.each([1, EXAGGERATION])('is where bends of %i times the size take it', (factor) => {
    drawn(factor, ['module']).forEach((pose, i) => {
      close(pose.elements, placed(factor)[i]?.elements ?? [], 1e-12);
    });
  });

  test('leaves a payload alone that it does not hold', () => {
    close(drawn(EXAGGERATION, [])[4]?.elements ?? [], placed(1)[4]?.elements ?? [], 1e-12);
  });
});

test('colours of a bent body are those of its shapes', () => {
  const materials = new Materials('low', new LambertLight(0));
  const shape = { kind: 'box', material: 'metal', size: [6, 1, 1], position: [3, 0, 0], rotation: [0, 0, 0] };
  const body = new Body({ name: 'boom', shapes: [shape], details: [] } as never, materials, 'low', END);
  body.bend(END, bend);
  const mesh = body.group.children[0] as never as {
    geometry: { getAttribute(name: string): { array: Float32Array } };
  };
  const values = mesh.geometry.getAttribute('color').array;
  const expected = materials.look('metal').colour;
  expect(new Color().fromArray(values).getHex()).toBe(expected.getHex());
  expect(new Set(Array.from(values)).size).toBeLessThanOrEqual(3);
});

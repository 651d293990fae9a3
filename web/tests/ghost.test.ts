import { LineSegments, Mesh, type Object3D, Scene } from 'three';
import { expect, test } from 'vitest';
import { Body } from '../src/scene/bodies';
import { Ghost } from '../src/scene/ghost';
import { LambertLight } from '../src/scene/lambert';
import { Materials } from '../src/scene/materials';

const BOX = {
  kind: 'box',
  material: 'bright',
  position: [0, 0, 0],
  rotation: [0, 0, 0],
  size: [1, 1, 1],
} as const;

function ghostOf(names: readonly string[]): { ghost: Ghost; parts: readonly Object3D[] } {
  const materials = new Materials('low', new LambertLight(0));
  const bodies = names.map((name) => new Body({ name, shapes: [BOX], details: [] }, materials, 'low'));
  for (const body of bodies) body.setPose([0, 0, 0, 1, 0, 0, 0], 0);
  const stage = new Scene();
  const ghost = new Ghost(stage, bodies, '#ffffff', { fill: 0.1, rim: 0.9 });
  return { ghost, parts: stage.children };
}

test('a ghost has faces and edges', () => {
  const { parts } = ghostOf(['boom']);
  const [filling, edges] = parts[0]?.children ?? [];
  expect(filling).toBeInstanceOf(Mesh);
  expect(edges).toBeInstanceOf(LineSegments);
});

test('only moving bodies have a ghost', () => {
  const { ghost, parts } = ghostOf(['boom', 'payload', 'joint']);
  const turned = [0, 0, 0, Math.cos(0.1), 0, 0, Math.sin(0.1)];
  ghost.set([1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, ...turned], performance.now() + 1000);
  ghost.setVisible(true);
  expect(parts.map(({ visible }) => visible)).toEqual([true, false, true]);
  ghost.setVisible(false);
  expect(parts.some(({ visible }) => visible)).toBe(false);
});

test('a ghost that another frame of the same drawing does not have is hidden in its pictures', () => {
  const { ghost, parts } = ghostOf(['boom']);
  const [poses, now] = [[1, 0, 0, 1, 0, 0, 0], performance.now() + 1000];
  const seen = (shown: number[] | null, at: number | null) => {
    ghost.set(shown, at);
    ghost.setVisible(true);
    return parts[0]?.visible;
  };
  expect([seen(poses, now), seen(null, null), seen(poses, null)]).toEqual([true, false, true]);
  expect(seen(null, now + 50)).toBe(true); // it fades
});

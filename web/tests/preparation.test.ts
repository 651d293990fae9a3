import { beforeEach, expect, test } from 'vitest';
import type { Drawer } from '../src/cameras/full-profile';
import { Preparation } from '../src/cameras/preparation';
import type { Frame } from '../src/link/protocol';

const FRAME = {} as Frame;

interface Made {
  readonly signal: AbortSignal;
  readonly drawer: Drawer;
  readonly progress: (done: number) => void;
  readonly scene: { isLost: boolean };
  disposed: boolean;
  finish(): void;
  fail(error: Error): void;
}

/** Preparations that a test finishes, and the progress that they have reported. */
let all: Made[];
let shown: (number | null)[];
let full: Preparation;

beforeEach(() => {
  all = [];
  shown = [];
  full = new Preparation(
    (_, signal, progress) =>
      new Promise((resolve, reject) => {
        const scene = {
          isLost: false,
          dispose() {
            made.disposed = true;
          },
        };
        const drawer = { scene } as unknown as Drawer;
        const finish = () => resolve(drawer);
        const made: Made = { ...{ signal, drawer, progress, scene, finish }, fail: reject, disposed: false };
        all.push(made);
      }),
    (done) => shown.push(done),
  );
});

/** Lets everything that is due happen. */
const settled = () => new Promise((resolve) => setTimeout(resolve, 0));

test('a prepared drawer is taken once', async () => {
  void full.start(FRAME);
  await settled();
  expect(full.take()).toBeNull();
  all[0]?.progress(0.5);
  all[0]?.finish();
  await settled();
  expect([full.take(), full.take(), all[0]?.disposed]).toEqual([all[0]?.drawer, null, false]);
  expect(shown.at(-1)).toBe(0.5);
});

test('a preparation starts only after an ended one, whose drawer is dropped', async () => {
  void full.start(FRAME);
  await settled();
  full.end();
  void full.start(FRAME);
  await settled();
  expect(all).toHaveLength(1);
  expect(all[0]?.signal.aborted).toBe(true);
  const before = shown.length;
  all[0]?.progress(0.9);
  expect(shown).toHaveLength(before);
  all[0]?.finish();
  await settled();
  expect([all.length, all[0]?.disposed, full.take()]).toEqual([2, true, null]);
  all[1]?.finish();
  await settled();
  expect(full.take()).toBe(all[1]?.drawer);
});

test('a drawer that is ready is dropped when its preparation ends or starts again', async () => {
  for (const again of [() => full.end(), () => void full.start(FRAME)]) {
    all = [];
    void full.start(FRAME);
    await settled();
    all[0]?.finish();
    await settled();
    again();
    expect([full.take(), all[0]?.disposed, shown.at(-1)]).toEqual([null, true, null]);
    full.end();
  }
});

test('a drawer that has lost its graphics is not taken', async () => {
  void full.start(FRAME);
  await settled();
  const [made] = all;
  if (made) made.scene.isLost = true;
  made?.finish();
  await settled();
  expect([full.take(), made?.disposed, shown.at(-1)]).toEqual([null, true, null]);
});

test('a failed preparation is reported, but not the one that was ended', async () => {
  const failed = full.start(FRAME);
  await settled();
  all[0]?.fail(new Error('no shaders'));
  await expect(failed).rejects.toThrow('no shaders');
  expect(shown.at(-1)).toBeNull();
  const ended = full.start(FRAME);
  await settled();
  full.end();
  all[1]?.fail(new Error('no graphics'));
  await expect(ended).resolves.toBeUndefined();
});

import { expect, it } from 'vitest';
import type { PlaybackIndex } from '../src/link/protocol';
import { FlownCameras } from '../src/replay/flown-cameras';

const RECORDED = [
  { time_s: 0, monitors: [['A'], ['B']] },
  { time_s: 10, monitors: [['C'], ['B', 'D']] },
] as unknown as PlaybackIndex['pictures'];

/** Monitors that report each change, as `Pictures` does. */
function replay(recorded: PlaybackIndex['pictures']) {
  const shown: (readonly string[])[] = [];
  const cameras: FlownCameras = new FlownCameras(recorded, {
    show(index, names) {
      shown[index] = names;
      cameras.changed();
    },
  });
  return { cameras, shown };
}

it('monitors show the cameras of the run at the playhead', () => {
  const { cameras, shown } = replay(RECORDED);
  cameras.show(9.9);
  expect(shown).toEqual([['A'], ['B']]);
  cameras.show(10);
  expect(shown).toEqual([['C'], ['B', 'D']]);
  expect(cameras.state).toBe(true);
});

it('a camera that the user chose stays until the user requests the run’s cameras', () => {
  const { cameras, shown } = replay(RECORDED);
  cameras.show(0);
  cameras.changed();
  expect(cameras.state).toBe(false);
  cameras.show(12);
  expect(shown).toEqual([['A'], ['B']]);
  cameras.reset();
  cameras.show(12);
  expect(shown).toEqual([['C'], ['B', 'D']]);
});

it('a recording without cameras has no state to follow', () => {
  expect(replay([]).cameras.state).toBeNull();
});

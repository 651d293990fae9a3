import { expect, test } from 'vitest';
import type { Block } from '../src/link/protocol';
import { Player } from '../src/replay/player';
import { EXTENT, player, run, settled } from './recording-player';

test('a recording opens paused at its first frame', async () => {
  const { player: made } = await player();
  made.advance(1);
  expect(made.moment?.frame.tick).toBe(1);
  expect(made.position).toBe(0.02);
});

test.each([0.25, 1, 8])('playback at speed %d advances the time by that factor', async (speed) => {
  const { player: made } = await player();
  made.speed = speed;
  made.play();
  await run(made, 1);
  expect(made.position).toBeCloseTo(0.02 + speed, 6);
  expect(made.moment?.frame.tick).toBe(Math.floor(made.position / 0.02 + 1e-6));
});

test('a paused recording keeps its position', async () => {
  const { player: made } = await player();
  made.play();
  await run(made, 0.5);
  made.toggle();
  const { position } = made;
  await run(made, 0.5);
  expect(made.position).toBe(position);
});

test('playback pauses at the end and starts again from the first frame', async () => {
  const { player: made } = await player();
  made.seek(19.9);
  await settled();
  made.play();
  await run(made, 0.3);
  expect(made.playing).toBe(false);
  expect(made.position).toBe(20);
  expect(made.moment?.frame.tick).toBe(1000);
  made.play();
  expect(made.position).toBe(0.02);
});

test('at each multiple of the period, the player shows the frame of that time', async () => {
  const { player: made } = await player();
  for (let tick = 1; tick <= 1000; tick += 1) {
    made.seek(tick * 0.02);
    expect(made.number).toBe(tick - 1);
  }
});

test('the playhead stays within the recording', async () => {
  const { player: made } = await player();
  made.seek(-5);
  expect(made.position).toBe(0.02);
  made.seek(1e9);
  expect(made.position).toBe(20);
  made.step(3);
  expect(made.position).toBe(20);
});

test('a step moves by one stored frame', async () => {
  for (const stride of [1, 7]) {
    const { player: made } = await player({ stride });
    made.seek(10);
    const { number } = made;
    made.step(1);
    expect(made.number).toBe(number + 1);
    made.step(-2);
    expect(made.number).toBe(number - 1);
  }
});

test('a thinned recording shows the last frame before the playhead', async () => {
  const { player: made } = await player({ stride: 10, block: 100 });
  made.seek(0.02 * 29);
  await settled();
  expect(made.moment?.frame.tick).toBe(21);
});

test('the playhead waits for frames that have not arrived', () => {
  const made = new Player(EXTENT, () => new Promise(() => {}));
  made.play();
  made.advance(1);
  expect(made.position).toBe(0.02);
  expect(made.moment).toBeNull();
});

test('each block is requested once and in advance, and few blocks are stored', async () => {
  const { player: made, requested } = await player({ ticks: 100_000 });
  expect(requested.toSorted()).toEqual([0, 1]);
  for (let second = 0; second < 600; second += 1) {
    made.seek(second);
    await settled();
  }
  expect(new Set(requested).size).toBe(requested.length);
  const kept = Reflect.get(made, 'blocks') as ReadonlyMap<number, Block>;
  expect(kept.size).toBeLessThanOrEqual(9);
  expect(made.moment?.frame.tick).toBe(599 * 50);
});

test('the last block of a recording is the last one requested', async () => {
  const { player: made, requested } = await player({ ticks: 250, stride: 1 });
  made.seek(5);
  await settled();
  expect(Math.max(...requested)).toBe(2);
});

test('a recording that does not answer is reported', async () => {
  const made = new Player(EXTENT, () => Promise.reject(new Error('gone')));
  await settled();
  expect(made.failure).toContain('does not answer');
});

test('the speed stays between 0.25 and 8', async () => {
  const { player: made } = await player();
  for (let i = 0; i < 9; i += 1) made.faster();
  expect(made.speed).toBe(8);
  for (let i = 0; i < 9; i += 1) made.slower();
  expect(made.speed).toBe(0.25);
});

import { expect, test } from 'vitest';
import type { Block, Frame, Moment, Strip } from '../src/link/protocol';
import { marks } from '../src/replay/axis';
import { actionOf } from '../src/replay/keys';
import { marksOf, stretchAt } from '../src/replay/lanes';
import { Player } from '../src/replay/player';
import { figure, minutes, withUnit } from '../src/replay/quantity';
import { began, drawnRate } from '../src/replay/rail';
import { following, LEAST_S, lengthOf, partOf, zoomed } from '../src/replay/span';
import { boundsOf, heights, path } from '../src/replay/strips';
import { unitsOf } from '../src/words/units';

const EXTENT = { period_s: 0.02, ticks: 1000, stride: 1, block: 100 };

/** A player of a recording whose blocks come at once, and the numbers of those asked for. */
async function player(extent: Partial<typeof EXTENT> = {}) {
  const all = { ...EXTENT, ...extent };
  const asked: number[] = [];
  const load = async (number: number): Promise<Block> => {
    asked.push(number);
    return Array.from({ length: all.block }, (_, i) => {
      const tick = 1 + (number * all.block + i) * all.stride;
      return { frame: { tick } as Frame, values: [], worst: '' } satisfies Moment;
    });
  };
  const made = new Player(all, load);
  await settled();
  return { player: made, asked };
}

const settled = () => new Promise((resolve) => setTimeout(resolve));

/** Advances by `dt` in steps of 10 ms, waiting for blocks between. */
async function run(made: Player, dt: number) {
  for (let i = 0; i < dt / 0.01; i += 1) {
    made.advance(0.01);
    await Promise.resolve();
    await Promise.resolve();
  }
}

test('a recording opens at its first frame, standing', async () => {
  const { player: made } = await player();
  made.advance(1);
  expect(made.moment?.frame.tick).toBe(1);
  expect(made.position).toBe(0.02);
});

test.each([0.25, 1, 8])('played at speed %d, time goes on by as much', async (speed) => {
  const { player: made } = await player();
  made.speed = speed;
  made.play();
  await run(made, 1);
  expect(made.position).toBeCloseTo(0.02 + speed, 6);
  expect(made.moment?.frame.tick).toBe(Math.floor(made.position / 0.02 + 1e-6));
});

test('paused, it stands', async () => {
  const { player: made } = await player();
  made.play();
  await run(made, 0.5);
  made.toggle();
  const { position } = made;
  await run(made, 0.5);
  expect(made.position).toBe(position);
});

test('at the end it pauses; played again it begins anew', async () => {
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

test('every multiple of the period shows its own frame', async () => {
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

test('steps go from frame to frame, thinned or not', async () => {
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

test('a thinned recording shows the last frame that is not ahead of the playhead', async () => {
  const { player: made } = await player({ stride: 10, block: 100 });
  made.seek(0.02 * 29);
  await settled();
  expect(made.moment?.frame.tick).toBe(21);
});

test('the playhead waits for frames that have not come', () => {
  const made = new Player(EXTENT, () => new Promise(() => {}));
  made.play();
  made.advance(1);
  expect(made.position).toBe(0.02);
  expect(made.moment).toBeNull();
});

test('a block is asked for once, the next ones ahead, and memory is bounded', async () => {
  const { player: made, asked } = await player({ ticks: 100_000 });
  expect(asked.toSorted()).toEqual([0, 1]);
  for (let second = 0; second < 600; second += 1) {
    made.seek(second);
    await settled();
  }
  expect(new Set(asked).size).toBe(asked.length);
  const kept = Reflect.get(made, 'blocks') as ReadonlyMap<number, Block>;
  expect(kept.size).toBeLessThanOrEqual(9);
  expect(made.moment?.frame.tick).toBe(599 * 50);
});

test('the last block is the last one asked for', async () => {
  const { player: made, asked } = await player({ ticks: 250, stride: 1 });
  made.seek(5);
  await settled();
  expect(Math.max(...asked)).toBe(2);
});

test('a recording that does not answer is told', async () => {
  const made = new Player(EXTENT, () => Promise.reject(new Error('gone')));
  await settled();
  expect(made.failure).toContain('does not answer');
});

test('speeds go up and down between their ends', async () => {
  const { player: made } = await player();
  for (let i = 0; i < 9; i += 1) made.faster();
  expect(made.speed).toBe(8);
  for (let i = 0; i < 9; i += 1) made.slower();
  expect(made.speed).toBe(0.25);
});

test('keys play, seek and step; others are not ours', async () => {
  const { player: made } = await player();
  const none = () => {};
  const keys = {
    event: none,
    desk: none,
    camera: none,
    stepCamera: none,
    otherMonitor: none,
    plane: none,
    matrix: none,
    split: none,
    asFlown: none,
    zoom: none,
    close: none,
  };
  const press = (code: string, shiftKey = false) => actionOf(made, keys, { code, shiftKey })?.();
  press('Space');
  expect(made.playing).toBe(true);
  press('End');
  expect(made.position).toBe(20);
  press('ArrowLeft');
  expect(made.position).toBe(19);
  press('ArrowLeft', true);
  expect(made.position).toBeCloseTo(18.98);
  press('Home');
  expect(made.position).toBe(0.02);
  expect(actionOf(made, keys, { code: 'KeyW', shiftKey: false })).toBeUndefined();
});

test('the stretch at a time is found, ends included', () => {
  const stretch = (start_s: number, end_s: number) => ({ start_s, end_s, label: '', level: 'info' }) as const;
  const stretches = [stretch(0, 1), stretch(1, 5), stretch(5, 6)];
  expect([0.02, 1, 1.02, 5, 5.5, 6, 7].map((time) => stretchAt(stretches, time))).toEqual([
    0, 0, 1, 1, 2, 2, 2,
  ]);
});

test('a curve is a path with gaps, higher values higher up', () => {
  const strip = { low: 0, high: 2, limit: null } as Strip;
  const height = heights(strip);
  expect(height(2)).toBeLessThan(height(0));
  expect([height(2) > 0, height(0) < 1]).toEqual([true, true]);
  const text = path({ role: 'actual', times_s: [1, 2, 3, 4], values: [0, 1, null, 2] }, (value) => value);
  expect(text).toBe('M1 0.0000L2 1.0000M4 2.0000');
});

test('a level strip is drawn, not divided by nothing', () => {
  expect(heights({ low: 0, high: 0, limit: null } as Strip)(0)).toBeGreaterThan(0);
  expect(Number.isFinite(heights({ low: 3, high: 3, limit: null } as Strip)(3))).toBe(true);
});

test('the axis has at most ten marks, round ones, none beyond the end', () => {
  for (const duration of [0.5, 12, 40.04, 512, 7200, 40_000]) {
    const times = marks({ from: 0, to: duration });
    expect(times.length).toBeLessThanOrEqual(10);
    expect(Math.max(...times)).toBeLessThan(duration);
  }
  expect(marks({ from: 0, to: 40.04 })).toEqual([0, 5, 10, 15, 20, 25, 30, 35]);
});

test('zoomed in, the marks are those of the part that is shown', () => {
  expect(marks({ from: 21, to: 31 })).toEqual([21, 22, 23, 24, 25, 26, 27, 28, 29, 30]);
  expect(marks({ from: 12.1, to: 14.1 })[0]).toBeCloseTo(12.2);
});

test('zooming keeps the playhead in its place, within the run', () => {
  const whole = { from: 0, to: 600 };
  const closer = zoomed(whole, 2, 300, 600);
  expect(closer).toEqual({ from: 150, to: 450 });
  expect(partOf(closer, 300)).toBe(partOf(whole, 300));
  expect(zoomed(closer, 0.5, 300, 600)).toEqual(whole);
  expect(zoomed(closer, 1 / 8, 300, 600)).toEqual(whole);
  expect(zoomed(whole, 1e6, 600, 600)).toEqual({ from: 600 - LEAST_S, to: 600 });
  expect(zoomed({ from: 0, to: 1 }, 2, 0.5, 1)).toEqual({ from: 0, to: 1 });
});

test('a span moves on with the playhead and stays within the run', () => {
  const span = { from: 100, to: 200 };
  expect(following(span, 150, 600)).toBe(span);
  for (const position of [201, 599, 99, 0, 600]) {
    const moved = following(span, position, 600);
    expect(lengthOf(moved)).toBe(100);
    expect(moved.from).toBeGreaterThanOrEqual(0);
    expect(moved.to).toBeLessThanOrEqual(600);
    expect(position).toBeGreaterThanOrEqual(moved.from);
    expect(position).toBeLessThanOrEqual(moved.to);
  }
});

test('what is taken and let go is marked once, however often the log tells it', () => {
  const line = (time_s: number, kind: string) => ({ time_s, kind, level: 'info', text: kind }) as const;
  const events = [
    line(1, 'mode'),
    line(2, 'captured'),
    line(2, 'acquired'),
    line(9, 'released'),
    line(9, 'released'),
  ];
  expect(marksOf(events).map(({ time_s, name }) => [time_s, name])).toEqual([
    [2, 'captured'],
    [9, 'released'],
  ]);
});

test('a figure of a distance and an angle says both', () => {
  const measure = {
    name: '',
    quantity: 'gap',
    value: 0.021,
    text: '',
    about: '',
    angle: Math.PI / 180,
    level: 'info',
  } as const;
  expect(figure(measure, unitsOf('SI'))).toBe('2.1 cm, 1.0°');
  expect(figure({ ...measure, angle: null }, unitsOf('ft-in'))).toBe('0.8 in');
});

test('a clearance is held against both thresholds, a rate against its limit', () => {
  expect(boundsOf({ limit: null, caution: 0.6, warning: 0.15 }).map(({ level }) => level)).toEqual([
    'caution',
    'warning',
  ]);
  expect(boundsOf({ limit: 1, caution: null, warning: null })).toEqual([{ level: 'limit', value: 1 }]);
});

test('A goes back to the cameras as flown, plus and minus zoom', async () => {
  const { player: made } = await player();
  const done: string[] = [];
  const none = () => {};
  const keys = {
    event: none,
    desk: none,
    camera: none,
    stepCamera: none,
    otherMonitor: none,
    plane: none,
    matrix: none,
    split: none,
    asFlown: () => done.push('as flown'),
    zoom: (way: number) => done.push(`zoom ${way}`),
    close: none,
  };
  for (const code of ['KeyA', 'Equal', 'Minus']) actionOf(made, keys, { code, shiftKey: false })?.();
  expect(done).toEqual(['as flown', 'zoom 1', 'zoom -1']);
});

test('times, values and rates are written as people read them', () => {
  expect(minutes(297.4, 2)).toBe('04:57.40');
  expect(minutes(3725)).toBe('1:02:05');
  expect(withUnit('speed', 0.3048, unitsOf('ft-in'))).toBe('1.00 ft/s');
  expect(withUnit('speed', 0.3048, unitsOf('SI'))).toBe('0.30 m/s');
  expect(withUnit('angle', -Math.PI / 2, unitsOf('SI'))).toBe('−90.0°');
  expect(withUnit('share', 0.314, unitsOf('SI'))).toBe('31 %');
  expect(withUnit('distance', null, unitsOf('SI'))).toBe('–');
  expect(drawnRate({ period_s: 0.02, stride: 10 })).toBe('Drawn 5 times a second');
  expect(drawnRate({ period_s: 0.02, stride: 20 })).toBe('Drawn 2.5 times a second');
  expect(drawnRate({ period_s: 0.02, stride: 100 })).toBe('Drawn every 2.0 s');
  expect(began('2026-03-01T14:05:09.123+00:00')).toBe('2026-03-01 14:05 UTC');
});

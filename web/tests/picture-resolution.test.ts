import { describe, expect, it, test } from 'vitest';
import { GOAL_MS, Resolution, SCALES, SLOW_MS, TURNS } from '../src/cameras/resolution';

const AREA = 500_000;

/** A renderer: a turn takes `fixed` ms, and `full` ms for its pixels in the screen's resolution; the page takes `page`. */
interface Renderer {
  readonly fixed: number;
  readonly full: number;
  readonly page: number;
}

/** Draws for a time [ms] from `now`; returns the scales chosen, and the end. */
function draw(
  resolution: Resolution,
  renderer: Renderer | ((now: number) => Renderer),
  ms: number,
  start = 0,
) {
  const scales: number[] = [];
  let now = start;
  while (now < start + ms) {
    const { fixed, full, page } = typeof renderer === 'function' ? renderer(now) : renderer;
    const drawing = fixed + full * resolution.scale ** 2;
    now += drawing + page;
    resolution.took({ period: drawing + page, drawing, area: AREA }, now);
    if (scales.at(-1) !== resolution.scale) scales.push(resolution.scale);
  }
  return { scales, now };
}

const period = ({ fixed, full, page }: Renderer, scale: number) => fixed + full * scale ** 2 + page;

/** The finest scale whose turns follow each other in time. */
const finest = (renderer: Renderer, most: number) =>
  SCALES.findLast((scale) => period(renderer, scale) <= most) ?? SCALES[0];

const machines: readonly Renderer[] = [2, 8, 16].flatMap((fixed) =>
  [4, 10, 20, 40, 80, 200, 1000].flatMap((full) => [2, 8].map((page) => ({ fixed, full, page }))),
);

describe.each(machines)('with %o ms', (machine) => {
  it('settles on a resolution that is fast enough, if there is one', () => {
    const resolution = new Resolution();
    const { scales, now } = draw(resolution, machine, 20_000);
    const settled = resolution.scale;
    expect(draw(resolution, machine, 20_000, now).scales).toEqual([settled]);
    expect(settled).toBeLessThanOrEqual(finest(machine, SLOW_MS));
    const next = SCALES[(SCALES as readonly number[]).indexOf(settled) + 1];
    // Before any change, the page cannot know which part of the time goes into pixels.
    const all = { fixed: 0, full: machine.full + machine.fixed / settled ** 2, page: machine.page };
    if (next) expect(period(scales.length > 1 ? machine : all, next)).toBeGreaterThan(GOAL_MS);
  });

  it('is never below half', () => {
    const { scales } = draw(new Resolution(), machine, 5000);
    expect(Math.min(...scales)).toBeGreaterThanOrEqual(0.5);
  });
});

test('a renderer without fixed costs has the finest resolution within the goal', () => {
  for (const full of [10, 30, 35, 50, 70, 100, 140, 143]) {
    const resolution = new Resolution();
    draw(resolution, { fixed: 0, full, page: 0 }, 30_000);
    const [goal, slow] = [GOAL_MS, SLOW_MS].map((most) => finest({ fixed: 0, full, page: 0 }, most));
    expect([goal, slow]).toContain(resolution.scale);
  }
});

test('the resolution falls within a second when the speed halves, and rises again', () => {
  const [fast, slow] = [
    { fixed: 2, full: 25, page: 5 },
    { fixed: 4, full: 50, page: 10 },
  ];
  const resolution = new Resolution();
  let { now } = draw(resolution, fast, 10_000);
  expect(resolution.scale).toBe(finest(fast, GOAL_MS));
  ({ now } = draw(resolution, slow, 1000, now));
  expect(period(slow, resolution.scale)).toBeLessThanOrEqual(SLOW_MS);
  ({ now } = draw(resolution, slow, 10_000, now));
  const before = resolution.scale;
  ({ now } = draw(resolution, fast, 10_000, now));
  expect(resolution.scale).toBeGreaterThan(before);
  expect(resolution.scale).toBe(finest(fast, GOAL_MS));
});

test('a few late turns change nothing', () => {
  const resolution = new Resolution();
  const steady = { fixed: 2, full: 20, page: 5 };
  let { now } = draw(resolution, steady, 10_000);
  const before = resolution.scale;
  for (let i = 0; i < 200; i += 1) {
    now += 30;
    const late = i % TURNS < (TURNS - 1) / 2;
    resolution.took({ period: late ? 300 : 27, drawing: late ? 290 : 22, area: AREA }, now);
    expect(resolution.scale).toBe(before);
  }
});

test('a load that comes and goes lets the resolution rise more and more rarely', () => {
  const resolution = new Resolution();
  // As soon as the resolution is above 0.7, another program takes the processor.
  const machine = () => ({ fixed: 2, full: resolution.scale > 0.7 ? 70 : 20, page: 5 });
  const first = draw(resolution, machine, 60_000);
  const second = draw(resolution, machine, 60_000, first.now);
  expect(second.scales.length).toBeLessThan(first.scales.length);
  expect(second.scales.length).toBeLessThan(8);
});

test('a still picture’s pieces take as long on every machine', () => {
  const [fast, slow] = [10, 20].map((full) => {
    const resolution = new Resolution();
    draw(resolution, { fixed: 0, full, page: 0 }, 10_000);
    return resolution.most;
  });
  expect((fast ?? 0) / (slow ?? 1)).toBeCloseTo(2, 1);
});

import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { type Age, isStale } from '../src/link/age';
import { Arrivals } from '../src/link/arrivals';
import type { Latency } from '../src/link/latency';
import type { Frame, Polygons, Welcome } from '../src/link/protocol';
import { DrawLoop, type Drawn } from '../src/page/draw-loop';
import { Freshness } from '../src/page/freshness';
import type { Operator } from '../src/page/operator';
import { PolygonPane } from '../src/panel/monitors/polygon-pane';
import { link, sent } from './sent-frames';
import { useSmallPage } from './small-page';

/** Time between two frames and between two readings of the ages [ms]. */
const [FRAME_MS, LOOK_MS] = [20, 100];
const FAULT = new Error('a fault');

let hidden: boolean;
let marked: boolean;

beforeEach(() => {
  [hidden, marked] = [false, false];
  vi.useFakeTimers();
  vi.stubGlobal('window', { setInterval: () => 0 });
  const toggle = (_: string, on: boolean) => {
    marked = on;
  };
  vi.stubGlobal('document', {
    get hidden() {
      return hidden;
    },
    body: { classList: { toggle, contains: () => marked } },
  });
});

afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

/** A page that draws each frame; `fault` is what goes wrong, and can be changed while the page runs. */
function page(delay: number, barPace = 1) {
  const world = { fault: '' };
  const arrivals = new Arrivals({ ...link(delay, delay), control_period_s: FRAME_MS / 1000 });
  const ages: Age[] = [];
  const told: string[] = [];
  const breaks = (fault: string) => {
    if (world.fault === fault) throw FAULT;
  };
  const parts = {
    pictures: {
      drawing: false,
      draw(_: Frame, done: () => void) {
        breaks('the pictures throw');
        if (world.fault !== 'the pictures are lost') done();
        return true;
      },
      setTime: () => breaks('the time codes throw'),
    },
    groups: { bars: () => breaks('the bars throw'), values: () => breaks('the numbers throw') },
    bars: () => {},
    values: () => breaks('the lamps throw'),
    viewOf: (frame: Frame) => ({ frame }),
  } as unknown as Drawn;
  const loop = new DrawLoop(
    { modes: [] } as unknown as Welcome,
    barPace,
    arrivals,
    { due: () => false, drawn() {}, answer: () => null, percentile95: () => null } as unknown as Latency,
    { sticks: {} } as unknown as Operator,
    parts,
  );
  const setAge = (of: (camera: string) => Age) => {
    const age = of('');
    ages.push(age);
    return age;
  };
  const freshness = new Freshness(arrivals, { setAge }, (_, level) => told.push(level));
  let tick = 0;
  return {
    ...{ world, told },
    /** Lets the page run for a time [ms], and returns whether the pictures and the numbers are marked as old. */
    run(time: number, linked = true) {
      for (const end = tick + time / FRAME_MS; tick < end; tick += 1) {
        const now = tick * FRAME_MS;
        vi.setSystemTime(now);
        vi.spyOn(performance, 'now').mockReturnValue(now);
        const late = (1000 * delay) / FRAME_MS;
        if (linked) arrivals.put(sent(tick, [late, late]), now);
        try {
          if (world.fault !== 'nothing is drawn any more' && !hidden) loop.draw(now);
        } catch (error) {
          if (error !== FAULT) throw error;
        }
        if (now % LOOK_MS === 0) freshness.look(now);
      }
      return { pictures: isStale(freshness.pictures), numbers: marked, undrawn: freshness.pictures.undrawn };
    },
  };
}

const FRESH = { pictures: false, numbers: false };
const WELL = ['the time codes throw', 'the bars throw', 'the numbers throw', 'the lamps throw'];

test.each<[string, { pictures: boolean; numbers: boolean }]>([
  ['the pictures throw', { pictures: true, numbers: true }],
  ['the pictures are lost', { pictures: true, numbers: false }],
  ['nothing is drawn any more', { pictures: true, numbers: true }],
  ...WELL.map((fault): [string, typeof FRESH] => [fault, { pictures: false, numbers: true }]),
])('if %s, what is not drawn is old after 0.5 s, and is fresh when it is drawn again', (fault, old) => {
  for (const [delay, barPace] of [
    [0, 1],
    [0, 2],
    [2, 1],
  ] as const) {
    const { world, run, told } = page(delay, barPace);
    for (let round = 0; round < 2; round += 1) {
      world.fault = '';
      expect(run(5000)).toMatchObject(FRESH);
      world.fault = fault;
      expect(run(400)).toMatchObject(FRESH);
      expect(run(300)).toMatchObject(old);
      expect(run(20_000)).toMatchObject(old);
    }
    expect(told).toEqual(old.pictures ? ['caution', 'info', 'caution'] : []);
  }
});

test('a page that draws nothing from its start is marked', () => {
  const { world, run } = page(0);
  world.fault = 'the pictures are lost';
  expect(run(800)).toMatchObject({ pictures: true, undrawn: true });
});

test('pictures are old without a link, and the page is not the cause', () => {
  const { run, told } = page(0);
  run(2000);
  expect(run(400, false)).toMatchObject(FRESH);
  expect(run(400, false)).toEqual({ pictures: true, numbers: true, undrawn: false });
  expect(told).toEqual([]);
});

test('a page that nobody sees does not grow old', () => {
  const { run } = page(0);
  run(2000);
  hidden = true;
  run(60_000);
  hidden = false;
  expect(run(20)).toMatchObject(FRESH);
});

test('a picture in the look of 1972 that arrives no more is old, unless the station says why or nobody sees it', () => {
  useSmallPage();
  vi.stubGlobal('window', { devicePixelRatio: 1 });
  const pane = new PolygonPane();
  Object.assign(pane.elements[0], { getContext: () => null });
  const picture = (step: number, text = '') => ({ step, text }) as Polygons;
  const size = { width: 100, height: 50 };
  const scene: Age = { s: 2, set: 2, undrawn: false };
  let now = 0;
  const unseen = (time: number) => {
    Object.assign(document, { hidden: true });
    for (const end = now + time; now < end; now += 1000) pane.ageOf(scene, now);
    Object.assign(document, { hidden: false });
    return isStale(pane.ageOf(scene, now));
  };
  const stale = (shown: () => Polygons | null) => {
    for (const end = now + 1000; now < end; now += 50) {
      pane.show(shown(), now, size);
      pane.ageOf(scene, now);
    }
    return isStale(pane.ageOf(scene, now));
  };
  const last = picture(7);
  expect(pane.ageOf(scene, now)).toBe(scene);
  expect(stale(() => picture(now))).toBe(false);
  expect(stale(() => last)).toBe(true);
  expect(stale(() => picture(now))).toBe(false);
  expect(unseen(60_000)).toBe(false);
  expect(stale(() => null)).toBe(true);
  const preparing = picture(-1, 'Preparing');
  expect(stale(() => preparing)).toBe(false);
  const still = () => {
    pane.show(last, last.step, size); // a paused replay shows it once
    for (const end = now + 1000; now < end; now += 50) pane.ageOf(scene, now);
    return isStale(pane.ageOf(scene, now));
  };
  expect(still()).toBe(false);
  pane.hide();
  expect(pane.ageOf(scene, now)).toBe(scene);
});

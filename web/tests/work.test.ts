import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { drawnGap } from '../src/cameras/pictures';
import { KEYS } from '../src/input/active-device';
import { Hold } from '../src/input/hold';
import type {
  Cargo,
  ClosestPoints,
  Condition,
  Frame,
  Near,
  Objective,
  WayOut,
  Work,
} from '../src/link/protocol';
import { ConditionBars } from '../src/panel/clearance/condition-bar';
import { figures, shortened, whatNow } from '../src/panel/clearance/conditions';
import { linesOf } from '../src/panel/clearance/contacts';
import { contactIn, FARTHEST, NEAREST, placeOf } from '../src/panel/clearance/gap-scale';
import { Places } from '../src/panel/clearance/places';
import { SPAN_S, Trend } from '../src/panel/clearance/trend';
import { wayParts } from '../src/panel/clearance/way-to-fixture';
import { working } from '../src/panel/controllers/key-map';
import { isMoving } from '../src/panel/desk/orbiter';
import { whereIs } from '../src/panel/effector/cargo';
import { graspWords } from '../src/panel/effector/effector';
import { isMoving as onItsWay } from '../src/panel/effector/prong';
import { seatNow } from '../src/panel/effector/seat';
import { angleAt, BAR, place } from '../src/panel/joints/joint-scale';
import { replaced } from '../src/panel/joints/master';
import { clipped, labelPlace } from '../src/panel/monitors/label-place';
import { Paced } from '../src/panel/parts/paced';
import { counted } from '../src/panel/spine/spine';
import { unitsOf } from '../src/words/units';

const [FEET, SI] = [unitsOf('ft-in'), unitsOf('SI')];

function near(parts: Partial<Near>): Near {
  return { a: 'palm', b: 'bar', clearance: 0.3, closing: 0, essential: false, ...parts } as Near;
}

function condition(parts: Partial<Condition>): Condition {
  const given = {
    name: 'palm height',
    unit: 'm' as const,
    value: 0,
    limit: 0.1,
    margin: 0.1,
    text: '',
    words: '',
    numbers: [],
    ...parts,
  };
  return { ...given, holds: given.margin >= 0 };
}

function work(parts: Partial<Work>): Work {
  return { contacts: [], inhibits: [], conditions: [], cargo: [], objective: null, ...parts } as Work;
}

test('the gauge is logarithmic between its ends, and stays on itself', () => {
  expect([placeOf(NEAREST), placeOf(FARTHEST)]).toEqual([0, 1]);
  expect([placeOf(-0.1), placeOf(0), placeOf(50)]).toEqual([0, 0, 1]);
  expect(placeOf(Math.sqrt(NEAREST * FARTHEST))).toBeCloseTo(0.5);
});

test('time to contact is told only while the gap closes', () => {
  expect(contactIn(0.4, 0.02)).toBeCloseTo(20);
  expect(contactIn(0.4, 0)).toBeNull();
  expect(contactIn(0.4, -0.02)).toBeNull();
  expect(contactIn(0, 0.02)).toBeNull();
  expect(contactIn(5, 0.002)).toBeNull();
});

test('the last minute runs from the left to now, and forgets what is older', () => {
  const trend = new Trend();
  for (let time = 0; time <= 100; time += 0.5) trend.add(time, time / 100);
  const path = trend.path(100, 1);
  expect(path.startsWith('M0.0000 0.6000L')).toBe(true);
  expect(path.endsWith('L1.0000 0.0000')).toBe(true);
  expect(trend.greatest).toBe(1);
  expect(path.match(/[ML]/g)).toHaveLength(2 * SPAN_S + 1);
});

test('where nothing is watched the curve has a gap, and a restart begins it anew', () => {
  const trend = new Trend();
  for (const [time, value] of [
    [0, 1],
    [1, null],
    [2, 1],
    [3, 0.5],
  ] as const)
    trend.add(time, value);
  expect(trend.path(3, 2).match(/M/g)).toHaveLength(2);
  trend.add(0.02, 1);
  expect(trend.path(0.02, 2)).toBe('M1.0000 0.5000');
});

test('what inhibits stands above what is made to touch, the deepest contact first', () => {
  const way: WayOut = {
    cause: 'contact',
    text: '',
    stick: 'translation',
    axis: 2,
    sign: -1,
    position: '',
  };
  const touching = work({
    contacts: [
      near({ a: 'prong', essential: true, clearance: 0 }),
      near({ a: 'wrist', b: 'payload top', clearance: -0.01 }),
      near({ b: 'payload top', clearance: -0.02 }),
    ],
  });
  const lines = linesOf({ work: touching, ways_out: [way] }, [], SI, KEYS);
  expect(lines.map(({ level }) => level)).toEqual(['warning', 'warning', 'caution', 'info']);
  expect(lines[0]?.text).toBe('Palm touches payload top, 2.0 cm deep');
  expect(lines[2]?.text).toBe('Way out: THC −Z (Q)');
  expect(lines[3]?.text).toBe('Made to touch: prong – bar');
});

test('a wide gap is not drawn, nor one that is closed', () => {
  const gap = {} as ClosestPoints;
  const drawn = (nearest: Near | null) => drawnGap({ work: { nearest }, display: { gap } } as Frame);
  expect(drawn(near({ clearance: 0.4 }))).toBe(gap);
  expect([drawn(null), drawn(near({ clearance: 5 })), drawn(near({ clearance: -0.01 }))]).toEqual([
    null,
    null,
    null,
  ]);
});

test('conditions that all find room keep the order given, whatever holds', () => {
  const places = new Places(3);
  const names = (...margins: number[]) =>
    places
      .order(margins.map((margin, i) => condition({ name: 'abc'.charAt(i), margin })))
      .map(({ name }) => name);
  expect(names(0.1, -0.9, 0)).toEqual(['a', 'b', 'c']);
  expect(names(0.1, -0.1, -0.9)).toEqual(['a', 'b', 'c']);
  expect(names(0.1, 0.1)).toEqual(['a', 'b']);
});

test('where not all find room what fails is shown, and takes the place of one that holds alone', () => {
  const places = new Places(3);
  const shown = (failing: string) =>
    places
      .order([...'abcde'].map((name) => condition({ name, margin: failing.includes(name) ? -1 : 1 })))
      .map(({ name }) => name)
      .join('');
  expect(shown('ce')).toBe('ace');
  expect(shown('ace')).toBe('ace');
  expect(shown('cde')).toBe('dce');
  expect(shown('')).toBe('dce');
  expect(shown('bc')).toBe('bce');
  expect(shown('abcde')).toBe('bce');
  expect(shown('acde')).toBe('ace');
});

test('a condition’s limit is at the middle of its bar, what holds is short of it', () => {
  const bars = new ConditionBars();
  const part = (value: number, limit: number) => {
    const one = condition({ value, limit, margin: limit - value });
    bars.learn([one]);
    return bars.part(one);
  };
  expect(part(0.05, 0.1)).toBeCloseTo(0.25);
  expect(part(0.1, 0.1)).toBeCloseTo(0.5);
  expect(part(0.15, 0.1)).toBeCloseTo(0.75);
  expect(part(5, 0.1)).toBe(1);
});

test('a window’s bar does not leap where the nearer bound changes', () => {
  const bars = new ConditionBars();
  const within = (value: number) => {
    const [limit, margin] = value > 0.05 ? [0.1, 0.1 - value] : [0, value];
    const one = condition({ value, limit, margin });
    bars.learn([one]);
    return bars.part(one);
  };
  within(0.2);
  expect(within(0.0501)).toBeCloseTo(within(0.0499), 2);
});

test('the way to the pin names the stick and the key that shorten it', () => {
  expect(wayParts([1.99, 0.3, -0.254], FEET, KEYS)).toEqual([
    { stick: '+X', handle: 'W', value: '78' },
    { stick: '+Y', handle: 'D', value: '12' },
    { stick: '−Z', handle: 'Q', value: '10' },
  ]);
  expect(wayParts([0.004, -0.05, 0], SI, KEYS)).toEqual([
    { stick: 'X', handle: '', value: '0.4' },
    { stick: '−Y', handle: 'A', value: '5.0' },
    { stick: 'Z', handle: '', value: '0.0' },
  ]);
});

test('figures are in the operator’s small units', () => {
  expect(figures(condition({ value: 0.0635 }), FEET)).toEqual({ value: '2.5', unit: 'in' });
  expect(figures(condition({ value: 1.2 }), SI)).toEqual({ value: '120', unit: 'cm' });
  expect(figures(condition({ value: 0.1, unit: 'rad' }), SI)).toEqual({ value: '5.7', unit: '°' });
  expect(figures(condition({ value: 0.03, unit: 'm/s' }), SI)).toEqual({ value: '3.0', unit: 'cm/s' });
  expect(figures(condition({ value: null as never }), SI).value).toBe('–');
});

test('once all is met the title says what to do, or nothing where it happens by itself', () => {
  const now = (action: Objective['action']) => whatNow(work({ objective: { action, text: '' } }), KEYS);
  expect(now('capture')).toBe(': squeeze, hold G');
  expect(now('acquire')).toBe('');
  expect(now('berth')).toBe(': latch, hold T');
  expect(now('insert')).toBe(': let go, hold R');
  expect(now('dock')).toBe('');
});

const CARGO = { name: 'payload', held: false, seat: '' } as Cargo;

test('a payload is in the grasp, in a seat, both, or free', () => {
  expect(whereIs(false, '')).toBe('free');
  expect(whereIs(false, 'Cargo bay')).toBe('Cargo bay');
  expect(whereIs(true, '')).toBe('held');
  expect(whereIs(true, 'Cargo bay')).toBe('held, fixed');
});

test('the end effector says what it holds, how heavy that is and how fast it may go; else how far the next is', () => {
  const payloads = [
    { id: 0, mass: 0, translation: [0.6, 0.1] },
    { id: 2, mass: 1000, translation: [0.06, 0.03] },
  ] as const;
  const words = (cargo: readonly Cargo[], fixture: number | null, rate: Frame['rate'] = 'coarse') =>
    graspWords({ work: { cargo }, display: { fixture, payload_id: 2 }, rate }, payloads, SI);
  const beacon = { ...CARGO, name: 'beacon', held: true };
  expect(words([CARGO, beacon], null)).toBe('beacon, 1000 kg, to 0.060 m/s');
  expect(words([CARGO, beacon], null, 'vernier')).toBe('beacon, 1000 kg, to 0.030 m/s');
  expect(words([CARGO], 4.2)).toBe('empty, fixture 420 cm away');
  expect(words([CARGO], 2.9)).toBe('empty');
  expect(words([CARGO], null)).toBe('empty');
  expect(words([], null)).toBe('');
});

test('the prong is on its way until it is where its switch sends it', () => {
  expect(onItsWay({ switch: 'stop', opening: 0.4 })).toBe(false);
  expect(onItsWay({ switch: 'close', opening: 0.4 })).toBe(true);
  expect(onItsWay({ switch: 'close', opening: 0 })).toBe(false);
  expect(onItsWay({ switch: 'open', opening: 0 })).toBe(true);
  expect(onItsWay({ switch: 'open', opening: 1 })).toBe(false);
});

test('the master alarm counts warnings and cautions apart, and nothing else', () => {
  const lit = (...levels: ('info' | 'caution' | 'warning')[]) => counted(levels.map((level) => ({ level })));
  expect(lit()).toBe('');
  expect(lit('info')).toBe('');
  expect(lit('caution', 'info')).toBe('1 caution');
  expect(lit('caution', 'warning', 'caution')).toBe('1 warning, 2 cautions');
});

test('the latch speaks of what is held, else of what is in a seat', () => {
  const seated = { ...CARGO, seat: 'bay' };
  expect(seatNow({ cargo: [seated, { ...CARGO, held: true }] })).toBe('');
  expect(seatNow({ cargo: [CARGO, seated] })).toBe('bay');
});

test('a switch that is held acts once, after its time', () => {
  const acted = vi.fn();
  const hold = new Hold(0.3, acted);
  hold.press(1000);
  expect(hold.tick(1150)).toBeCloseTo(0.5);
  expect(acted).not.toHaveBeenCalled();
  hold.tick(1310);
  hold.tick(1900);
  hold.lift(2000);
  expect(acted).toHaveBeenCalledTimes(1);
  hold.press(3000);
  hold.lift(3200);
  expect(acted).toHaveBeenCalledTimes(1);
});

test('a switch held long enough acts though nobody looked meanwhile', () => {
  const acted = vi.fn();
  const hold = new Hold(0.3, acted);
  hold.press(1000);
  hold.lift(1400);
  expect(acted).toHaveBeenCalledTimes(1);
});

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

test('the master is told at most twenty times a second, and its last place always', () => {
  const told: number[] = [];
  const paced = new Paced<number>(50, (value) => told.push(value));
  for (let i = 0; i < 100; i += 1) {
    paced.put(i);
    vi.advanceTimersByTime(10);
  }
  vi.advanceTimersByTime(200);
  expect(told.length).toBeLessThanOrEqual(21);
  expect([told[0], told.at(-1)]).toEqual([0, 99]);
  vi.advanceTimersByTime(1000);
  paced.put(7);
  expect(told.at(-1)).toBe(7);
});

test('one slider moves one angle of the master', () => {
  expect(replaced([1, 2, 3, 4, 5, 6], 2, 9)).toEqual([1, 2, 9, 4, 5, 6]);
});

test('a place on a joint’s bar is the angle that stands there', () => {
  const joint = { hard: [-3, 3], soft: [-2.9, 2.9], reach: [-2.7, 2.7] } as const;
  for (let at = 0; at <= BAR; at += 8.5) expect(place(joint, angleAt(joint, at))).toBeCloseTo(at);
  expect([angleAt(joint, -5), angleAt(joint, BAR + 5)]).toEqual([-3, 3]);
});

test('the orbiter rests below a tenth of a millimetre a second', () => {
  expect(isMoving({ orbiter_velocity: [0, 5e-5, 0] })).toBe(false);
  expect(isMoving({ orbiter_velocity: [0, 0, -0.01] })).toBe(true);
});

const BOX = { left: 0, top: 0, right: 100, bottom: 80 };

test('a line is cut off at the picture’s edges', () => {
  expect(clipped({ x: -50, y: 40 }, { x: 50, y: 40 }, BOX)).toEqual([
    { x: 0, y: 40 },
    { x: 50, y: 40 },
  ]);
  expect(clipped({ x: 10, y: -5 }, { x: 90, y: -1 }, BOX)).toBeNull();
  expect(clipped({ x: -30, y: 70 }, { x: 30, y: 130 }, BOX)).toBeNull();
  expect(clipped({ x: 10, y: 10 }, { x: 10, y: 10 }, BOX)).not.toBeNull();
});

test('a label stands on the side away from the middle, inside the picture, and covers nothing', () => {
  const picture = { width: 600, height: 400 };
  const label = { width: 60, height: 20 };
  const at = (x: number, y: number, taken: (typeof BOX)[] = []) =>
    labelPlace(
      [
        { x, y },
        { x: x + 20, y },
      ],
      label,
      picture,
      taken,
    );
  expect(at(200, 200).x + label.width).toBeLessThan(200);
  expect(at(400, 200).x).toBeGreaterThan(420);
  expect(at(10, 200).x).toBeGreaterThan(30);
  const beside = { left: 100, top: 150, right: 199, bottom: 250 };
  expect(at(200, 200, [beside]).x).toBeGreaterThan(220);
  const corner = { left: 480, top: 370, right: 600, bottom: 400 };
  const { x: left, y: top } = at(575, 385, [corner]);
  expect(left < 480 - label.width || top <= 370 - label.height).toBe(true);
  for (const x of [-10, 0, 300, 590, 620]) {
    const { x: left, y: top } = at(x, 2);
    expect(left >= 0 && top >= 0 && left + label.width <= 600 && top + label.height <= 400).toBe(true);
  }
});

test('a label beside a slanting line keeps near to it, and clear of it', () => {
  const label = { width: 40, height: 20 };
  const [a, b] = [
    { x: 300, y: 100 },
    { x: 500, y: 200 },
  ];
  const { x, y } = labelPlace([a, b], label, { width: 600, height: 400 }, []);
  const corners = [x, x + label.width].flatMap((u) => [y, y + label.height].map((v) => ({ u, v })));
  const off = corners.map(({ u, v }) => (100 * (u - a.x) - 200 * (v - a.y)) / Math.hypot(200, 100));
  expect(Math.min(...off.map(Math.abs))).toBeCloseTo(12, 6);
  expect(new Set(off.map(Math.sign)).size).toBe(1);
});

test('a cell holds the words that tell a trunnion from a latch, and each from the others', () => {
  const guides = ['forward port', 'forward starboard', 'aft port', 'aft starboard', 'keel'];
  const names = guides.flatMap((guide) => [`${guide} trunnion in guide`, `${guide} latch ready`]);
  const shown = names.map(shortened);
  expect(new Set(shown).size).toBe(names.length);
  expect(shown[2]).toBe('fwd stbd in guide');
  expect(Math.max(...shown.map((name) => name.length))).toBeLessThan(21);
});

test('the key map lists what this arm has, and no more', () => {
  const told = (hand: 'prong' | 'snares', stand: object | null) =>
    working({ work: { hand, stand } } as Parameters<typeof working>[0])
      .map(([, does]) => does)
      .join();
  expect(told('snares', null)).not.toMatch(/prong|telescope/);
  expect(told('prong', {})).toMatch(/prong.*telescope/);
  expect(told('prong', {})).not.toMatch(/capture/);
});

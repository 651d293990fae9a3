import { expect, test } from 'vitest';
import { drawnGap } from '../src/cameras/staging';
import { KEYS } from '../src/input/active-device';
import type { ClosestPoints, Frame, Near, Objective, WayOut } from '../src/link/protocol';
import { taskPairWords } from '../src/panel/clearance/clearance';
import { ConditionBars } from '../src/panel/clearance/condition-bar';
import { figures, shortened, whatNow } from '../src/panel/clearance/conditions';
import { linesOf } from '../src/panel/clearance/contacts';
import { contactIn, FARTHEST, NEAREST, placeOf } from '../src/panel/clearance/gap-scale';
import { Places } from '../src/panel/clearance/places';
import { SPAN_S, Trend } from '../src/panel/clearance/trend';
import { failureText } from '../src/words/condition-text';
import { condition, FEET, near, SI, work } from './worksite';

test('the clearance gauge is logarithmic and clamped to its ends', () => {
  expect([placeOf(NEAREST), placeOf(FARTHEST)]).toEqual([0, 1]);
  expect([placeOf(-0.1), placeOf(0), placeOf(50)]).toEqual([0, 0, 1]);
  expect(placeOf(Math.sqrt(NEAREST * FARTHEST))).toBeCloseTo(0.5);
});

test('the time to contact is shown only while the clearance decreases', () => {
  expect(contactIn(0.4, 0.02)).toBeCloseTo(20);
  expect(contactIn(0.4, 0)).toBeNull();
  expect(contactIn(0.4, -0.02)).toBeNull();
  expect(contactIn(0, 0.02)).toBeNull();
  expect(contactIn(5, 0.002)).toBeNull();
});

test('the curve shows only the last minute', () => {
  const trend = new Trend();
  for (let time = 0; time <= 100; time += 0.5) trend.add(time, time / 100);
  const path = trend.path(100, 1);
  expect(path.startsWith('M0.0000 0.6000L')).toBe(true);
  expect(path.endsWith('L1.0000 0.0000')).toBe(true);
  expect(trend.greatest).toBe(1);
  expect(path.match(/[ML]/g)).toHaveLength(2 * SPAN_S + 1);
});

test('the curve has a gap while no pair is monitored, and is cleared at a restart', () => {
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

test('contacts that inhibit are listed first, the deepest one on top', () => {
  const way: WayOut = {
    cause: 'contact',
    text: '',
    stick: 'translation',
    axis: 2,
    sign: -1,
    position: '',
  };
  const dynamics = {
    contacts: [{ a: 'palm', b: 'payload top', force: [300, 0, -161], position: [0, 0, 0] }],
    holds: [
      { payload: 'payload', by: 'end effector', force: 81.4 },
      { payload: 'payload', by: 'orbiter', force: 0.3 },
    ],
  } as unknown as NonNullable<Frame['dynamics']>;
  const touching = work({
    contacts: [
      near({ a: 'prong', essential: true, clearance: 0 }),
      near({ a: 'wrist', b: 'payload top', clearance: -0.01 }),
      near({ b: 'payload top', clearance: -0.02 }),
    ],
  });
  const lines = linesOf({ work: touching, ways_out: [way], dynamics: null }, [], SI, KEYS);
  expect(lines.map(({ level }) => level)).toEqual(['warning', 'warning', 'caution', 'info']);
  expect(lines[0]?.text).toBe('Palm touches payload top, 2.0 cm deep');
  expect(lines[2]?.text).toBe('Escape: THC −Z (Q)');
  expect(lines[3]?.text).toBe('Essential contact: prong – bar');
  const forces = linesOf({ work: touching, ways_out: [], dynamics }, [], SI, KEYS).map(({ text }) => text);
  expect(forces.filter((text) => text.includes('N'))).toEqual([
    'Palm touches payload top, 2.0 cm deep, 340 N',
    'Grasp, 81 N',
  ]);
});

test('conditions keep their order if each of them has a cell', () => {
  const places = new Places(3);
  const names = (...margins: number[]) =>
    places
      .order(margins.map((margin, i) => condition({ name: 'abc'.charAt(i), margin })))
      .map(({ name }) => name);
  expect(names(0.1, -0.9, 0)).toEqual(['a', 'b', 'c']);
  expect(names(0.1, -0.1, -0.9)).toEqual(['a', 'b', 'c']);
  expect(names(0.1, 0.1)).toEqual(['a', 'b']);
});

test('with too few cells, a failed condition replaces a condition that holds', () => {
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

test('a condition holds up to the middle of its bar', () => {
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

test('the bar of a range is continuous where the nearer bound changes', () => {
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

test('values are in the operator’s small units', () => {
  expect(figures(condition({ value: 0.0635 }), FEET)).toEqual({ value: '2.5', unit: 'in' });
  expect(figures(condition({ value: 1.2 }), SI)).toEqual({ value: '120', unit: 'cm' });
  expect(figures(condition({ value: 0.1, unit: 'rad' }), SI)).toEqual({ value: '5.7', unit: '°' });
  expect(figures(condition({ value: 0.03, unit: 'm/s' }), SI)).toEqual({ value: '3.0', unit: 'cm/s' });
  expect(figures(condition({ value: null as never }), SI).value).toBe('–');
});

test('the title names the next action once all conditions hold', () => {
  const now = (action: Objective['action']) => whatNow(work({ objective: { action, text: '' } }), KEYS);
  expect(now('capture')).toBe(': capture, hold G');
  expect(now('acquire')).toBe('');
  expect(now('berth')).toBe(': latch, hold T');
  expect(now('insert')).toBe(': release, hold R');
  expect(now('dock')).toBe('');
});

test('a cell text distinguishes trunnions and latches', () => {
  const guides = ['forward port', 'forward starboard', 'aft port', 'aft starboard', 'keel'];
  const names = guides.flatMap((guide) => [`${guide} trunnion in guide`, `${guide} latch ready`]);
  const shown = names.map(shortened);
  expect(new Set(shown).size).toBe(names.length);
  expect(shown[2]).toBe('fwd stbd in guide');
  expect(Math.max(...shown.map((name) => name.length))).toBeLessThan(21);
});

test('a wide or zero clearance is not drawn', () => {
  const gap = {} as ClosestPoints;
  const drawn = (nearest: Near | null) => drawnGap({ work: { nearest }, display: { gap } } as Frame);
  expect(drawn(near({ clearance: 0.4 }))).toBe(gap);
  expect([drawn(null), drawn(near({ clearance: 5 })), drawn(near({ clearance: -0.01 }))]).toEqual([
    null,
    null,
    null,
  ]);
});

test('the fingers close last: the condition named first is the one to meet first', () => {
  const open = condition({ name: 'prong closed', margin: -1, words: 'fingers apart' });
  const high = condition({ name: 'palm height', margin: -1, words: 'palm high' });
  const along = condition({ name: 'palm along bar', words: 'along' });
  expect(failureText([open, high, along], SI)).toBe('palm high');
  expect(failureText([open, along], SI)).toBe('fingers apart');
  expect(failureText([along], SI)).toBe('');
});

test('the pair that the task brings together has its own number, unless it is the minimum clearance already', () => {
  const task = { a: 'prong', b: 'receptacle', clearance: 0.254, closing: 0 };
  const left = { task_pair: task };
  expect(taskPairWords(left, { a: 'palm', b: 'wall' }, FEET)).toMatch(/10.* in, prong to receptacle$/);
  expect(taskPairWords(left, null, SI)).toContain('25');
  expect(taskPairWords(left, task, FEET)).toBe('');
  expect(taskPairWords({ task_pair: null }, task, FEET)).toBe('');
  const moving = (closing: number) => taskPairWords({ task_pair: { ...task, closing } }, null, FEET);
  expect(moving(0.127)).toContain('contact in 2 s, prong');
  expect(moving(-0.127)).not.toContain('contact');
});

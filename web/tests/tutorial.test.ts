import { expect, test } from 'vitest';
import { isDown } from '../src/input/active-device';
import { DEFAULTS } from '../src/input/defaults';
import { USES } from '../src/input/keymap';
import { movers } from '../src/input/rebind';
import type { Condition, Frame, Work } from '../src/link/protocol';
import { farewell } from '../src/tutorial';
import { BEGIN, back, isOver, looked, type Progress, seen, skip } from '../src/tutorial/progress';
import { LIFTED, MOVED, STEPS } from '../src/tutorial/steps';
import { pieces } from '../src/tutorial/words';
import { unitsOf } from '../src/words/units';

const [FEET, SI] = [unitsOf('ft-in'), unitsOf('SI')];

interface Flown {
  readonly tick?: number;
  readonly x?: number;
  readonly stick?: number;
  readonly offAxis?: boolean;
  /** Value of the condition `pin off axis` [m]; the capture envelope allows at most 0.1 m. */
  readonly aside?: number;
  readonly depth?: boolean;
  readonly held?: boolean;
  readonly seat?: string;
  readonly flags?: readonly string[];
  readonly closing?: boolean;
  readonly rate?: Frame['rate'];
  readonly warns?: boolean;
}

function condition(name: string, holds: boolean, value = 0): Condition {
  return {
    name,
    holds,
    value,
    limit: 0.1,
    unit: 'm',
    margin: 0,
    words: `${name} fails`,
    numbers: [],
  };
}

/**
 * Returns a frame. By default, the end effector is above the berthed payload, nothing is captured, and no capture
 * condition holds.
 */
function frame(flown: Flown = {}): Frame {
  const { tick = 1, x = 0, stick = 0, held = false, seat = 'bay', flags = ['EXTEND', 'OPEN'] } = flown;
  const work = {
    conditions: held
      ? []
      : [
          condition('pin off axis', flown.offAxis ?? false, flown.aside),
          condition('pin depth', flown.depth ?? false),
        ],
    hand: { flags, switch: flown.closing ? 'close' : 'stop' },
    cargo: [{ name: 'payload', held, seat }],
    clearance_level: flown.warns ? 'warning' : 'info',
  } as unknown as Work;
  const { rate = 'coarse' } = flown;
  return {
    tick,
    rate,
    translation: [stick, 0, 0],
    display: { actual: { position: [x, 0, 0] } },
    work,
  } as unknown as Frame;
}

function at(name: string): Progress {
  return { ...BEGIN, at: STEPS.findIndex((step) => step.name === name), tick: 0 };
}

/** One frame for each state in which a step has another text. */
const STATES: readonly Frame[] = [
  frame(),
  frame({ offAxis: true }),
  frame({ depth: true }),
  frame({ offAxis: true, depth: true }),
  frame({ closing: true }),
  frame({ flags: ['CLOSE'] }),
  frame({ held: true }),
  frame({ held: true, flags: ['RIGID'] }),
  frame({ held: true, flags: ['RIGID'], seat: '' }),
  frame({ held: true, flags: ['RIGID'], seat: '', rate: 'vernier', warns: true }),
];

test('each of the six steps can be completed, but not at rest', () => {
  expect(STEPS.map(({ name }) => name)).toEqual(['look', 'move', 'line up', 'close in', 'capture', 'lift']);
  const still = { from: [0, 0, 0], looked: false, lifted: 0 } as const;
  const all = { from: [9, 9, 9], looked: true, lifted: LIFTED } as const;
  for (const step of STEPS) {
    expect(step.done(frame(), still)).toBe(false);
    expect(STATES.some((now) => step.done(now, all))).toBe(true);
  }
});

test('texts and key caps name only existing keys and buttons and are short', () => {
  for (const step of STEPS) {
    const named = STATES.flatMap((now) => pieces(step.words(now, FEET)))
      .filter(({ kind }) => kind === 'use')
      .map(({ text }) => text);
    for (const use of [...named, ...STATES.flatMap((now) => step.caps(now).map(([name]) => name)), 'stop']) {
      expect(USES.has(use), use).toBe(true);
      expect(movers(DEFAULTS.keyboard, use).length, `${use} by keys`).toBeGreaterThan(0);
      expect(movers(DEFAULTS.pad, use).length, `${use} by pad`).toBeGreaterThan(0);
    }
    for (const now of STATES)
      for (const units of [FEET, SI]) expect(step.words(now, units).length).toBeLessThan(260);
  }
});

test('texts are in the operator’s units', () => {
  const closing = (name: string, flown: Flown, units = SI) =>
    STEPS.find((step) => step.name === name)?.words(frame(flown), units) ?? '';
  expect(closing('line up', {})).toContain('under 5.0 cm');
  expect(closing('line up', {}, FEET)).toContain('under 2.0 in');
  expect(closing('close in', { offAxis: true })).toContain('the last 30 cm');
  expect(closing('lift', { held: true, flags: ['RIGID'], seat: '' })).toContain('is 1 m above');
});

test('the lift step names the key that lifts, and explains an alarm near the berth', () => {
  const lift = STEPS.at(-1);
  const free = { held: true, flags: ['RIGID'], seat: '' };
  expect(lift?.caps(frame({ ...free, seat: 'bay' }))).toEqual([['latch', 'unlatch']]);
  expect(lift?.caps(frame(free)).map(([use]) => use)).toEqual(['-X', 'rate']);
  expect(lift?.words(frame({ ...free, rate: 'vernier' }), SI)).toContain('{rate} changes to fast');
  expect(lift?.words(frame({ ...free, warns: true }), SI)).toContain('*CLEARANCE* warns');
  expect(lift?.words(frame(free), SI)).not.toMatch(/rate|CLEARANCE/);
});

test('marks split a text into pieces', () => {
  expect(pieces('Hold {+X}: *RIGID*.')).toEqual([
    { kind: 'text', text: 'Hold ' },
    { kind: 'use', text: '+X' },
    { kind: 'text', text: ': ' },
    { kind: 'shown', text: 'RIGID' },
    { kind: 'text', text: '.' },
  ]);
});

test('a whole run completes each step in order', () => {
  let progress = seen(BEGIN, frame(), -2);
  const fly = (flown: Flown, height = -2) => {
    progress = seen(progress, frame({ tick: progress.tick + 1, ...flown }), height);
    return STEPS[progress.at]?.name ?? 'over';
  };
  expect(fly({ x: 5 })).toBe('look');
  progress = looked(progress);
  expect(fly({ x: 5 })).toBe('move');
  expect(fly({ x: 5 })).toBe('move');
  expect(fly({ x: 5 + 0.9 * MOVED })).toBe('move');
  expect(fly({ x: 5 - 1.01 * MOVED })).toBe('line up');
  expect(fly({ depth: true })).toBe('line up');
  expect(fly({ offAxis: true, stick: 1 })).toBe('line up');
  expect(fly({ offAxis: true, aside: 0.099 })).toBe('line up');
  expect(fly({ offAxis: true })).toBe('close in');
  expect(fly({ offAxis: true })).toBe('close in');
  expect(fly({ offAxis: true, depth: true, stick: 1 })).toBe('capture');
  expect(fly({ offAxis: true, depth: true })).toBe('capture');
  expect(fly({ held: true })).toBe('lift');
  expect(fly({ held: true }, -1.9)).toBe('lift');
  expect(fly({ held: true, seat: '' }, -1.9)).toBe('lift');
  expect(fly({ held: true, seat: '' }, -1.9 + 0.9 * LIFTED)).toBe('lift');
  expect(fly({ held: false, seat: '' }, 5)).toBe('lift');
  expect(fly({ held: true, seat: '' }, -1.9 + 1.01 * LIFTED)).toBe('over');
  expect(isOver(progress)).toBe(true);
  expect(fly({}, 0)).toBe('over');
});

test('a restart starts the tutorial again from the present tip position', () => {
  const late = { ...at('capture'), tick: 900, from: [1, 2, 3] as const };
  const progress = seen(late, frame({ tick: 1, x: 7 }), -2);
  expect(progress).toMatchObject({ at: 0, tick: 1, from: [7, 0, 0], seat: -2 });
});

test('with a captured payload, the tutorial starts at the lift step', () => {
  expect(seen(BEGIN, frame({ held: true }), 0).at).toBe(STEPS.length - 1);
});

test('a repeated step ends when it is done again', () => {
  const lined = (tick: number, offAxis: boolean) => frame({ tick, offAxis });
  let progress = back(at('close in'));
  expect(STEPS[progress.at]?.name).toBe('line up');
  progress = seen(progress, lined(1, true), 0);
  expect(STEPS[progress.at]?.name).toBe('line up');
  progress = seen(progress, lined(2, false), 0);
  expect(STEPS[seen(progress, lined(3, true), 0).at]?.name).toBe('close in');
  expect(back(BEGIN).at).toBe(0);
});

test('skipping stops at the last step', () => {
  let progress = BEGIN;
  for (const _ of STEPS) progress = skip(progress);
  expect(isOver(progress)).toBe(true);
  expect(skip(progress)).toEqual(progress);
  expect(progress.skipped.size).toBe(STEPS.length);
});

test('a step that was skipped and then flown counts as done', () => {
  const skipped = skip(at('move'));
  expect([...skipped.skipped]).toEqual([1]);
  let progress = seen(back(skipped), frame({ tick: 1, x: 0 }), 0);
  expect(progress.skipped.size).toBe(1);
  progress = seen(progress, frame({ tick: 2, x: 1.01 * MOVED }), 0);
  expect([STEPS[progress.at]?.name, progress.skipped.size]).toEqual(['line up', 0]);
});

test('an axis counts as held if it is past its deadband on the given side', () => {
  const buttons = Array.from({ length: 17 }, (_, i) => ({ pressed: i === 9 || i === 3, value: 0 }));
  const device = { reading: { axes: [0.02, -0.5], buttons }, mapping: DEFAULTS.pad };
  expect([isDown(device, 'a1', -1), isDown(device, 'a1', 1), isDown(device, 'a0', 1)]).toEqual([
    true,
    false,
    false,
  ]);
  expect([isDown(device, 'b3', 1), isDown(device, 'b9+b3', 1), isDown(device, 'b9+b0', 1)]).toEqual([
    true,
    true,
    false,
  ]);
  expect(isDown({ reading: null, mapping: DEFAULTS.pad }, 'b3', 1)).toBe(false);
});

test('the closing text says "complete" only without skipped steps', () => {
  let progress: Progress = { ...BEGIN, at: STEPS.length };
  for (const now of [frame(), frame({ held: true }), frame({ seat: '' })]) {
    progress = seen(progress, now, 0);
    expect(farewell(progress.flown)[0]).toBe('Not complete yet');
  }
  progress = seen(progress, { ...frame({ held: true, seat: '' }), time_s: 90 }, 0);
  expect(farewell(progress.flown)[0]).toBe('Complete');
});

test('the closing time is kept until a step is repeated', () => {
  const later = (progress: Progress, flown: Flown, time_s: number) =>
    seen(progress, { ...frame(flown), time_s }, 2 * LIFTED);
  let progress: Progress = { ...at('lift'), seat: 0 };
  progress = later(progress, { held: true, seat: '' }, 376);
  expect(progress.flown).toBe(376);
  progress = later(progress, { held: true, seat: '' }, 394);
  progress = later(progress, { seat: '' }, 400);
  expect(progress.flown).toBe(376);
  expect(back(progress).flown).toBeNull();
});

test('the closing text has the time', () => {
  const closing = (flown: number) => farewell(flown).join();
  expect(closing(59.9)).toMatch(/^Complete.*, 59 s after/);
  expect(closing(185)).toMatch(/, 3 min 5 s after/);
});

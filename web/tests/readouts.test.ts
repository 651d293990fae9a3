import { afterEach, describe, expect, it, test, vi } from 'vitest';
import type { Frame, Lamp } from '../src/link/protocol';
import { Control } from '../src/page/control';
import type { Parts } from '../src/page/parts';
import { inUnits, Readouts } from '../src/page/readouts';
import type { Measured } from '../src/panel/rail/rail';
import type { SpineLamp } from '../src/panel/spine/lamps';
import { type Units, unitsOf } from '../src/words/units';

afterEach(() => {
  vi.unstubAllGlobals();
});

const INCHES = unitsOf('ft-in');
const SI = unitsOf('SI');

const SINGULAR: Lamp = { name: 'SINGULAR', level: 'caution', text: 'elbow', standing: false };
const CLEARANCE: Lamp = { name: 'CLEARANCE', level: 'warning', text: 'near', standing: false };
const NEAREST = { a: 'elbow', b: 'door', clearance: 0.1 };

const frameOf = (mode: string, lamps: readonly Lamp[], nearest: object | null = null) =>
  ({ mode, work: { nearest }, display: { lamps } }) as unknown as Frame;

const none = { set: 0, measured: null };
const MEASURED = {
  picture: 20,
  delays: { command: none, telemetry: none, camera: none },
} as unknown as Measured;

/** The parts that show a frame; they record what they receive. */
function desk() {
  const control = new Control();
  control.role = { ...control.role, flying: true, flier: 2, names: [{ number: 2, name: 'Anna' }] };
  const shown: { lamps: readonly SpineLamp[]; test: boolean }[] = [];
  const controllers = { shown: {}, lost: [] as { short: string }[], waiting: [] };
  const report = vi.fn();
  const parts = {
    control,
    units: { units: INCHES },
    operator: { sticks: { value: [0.5, 0, 0, 0, 0, 0], flyingOrbiter: true }, controllers },
    arrivals: { silence: () => 0 },
    freshness: { pictures: { s: 0, set: 0 } },
    log: { refusedAt: -Infinity },
    controlPage: { values() {} },
    task: { values() {} },
    opening: { values() {} },
    rail: { values() {} },
    handOver: { words: () => '' },
    sounds: { update: vi.fn() },
    spine: { show: (lamps: readonly SpineLamp[], test: boolean) => shown.push({ lamps, test }) },
    report: { update: report },
    pictures: { monitors: { shown: [['A'], ['B']] } },
    groups: { mode: { inView: () => undefined } },
    calm: { values: vi.fn() },
  };
  const readouts = new Readouts(parts as unknown as Parts);
  const show = (frame: Frame, now = 10_000) => readouts.values(readouts.viewOf(frame), MEASURED, now);
  return { control, controllers, parts, readouts, report, shown, show };
}

describe('CLEARANCE', () => {
  const text = (frame: Frame, units: Units) => inUnits({ frame, units }).map((lamp) => lamp.text);

  it('shows the minimum clearance in the units of the operator', () => {
    const frame = frameOf('ORB UNL', [SINGULAR, CLEARANCE], NEAREST);
    const [inches, si] = [text(frame, INCHES), text(frame, SI)];
    expect([inches[0], si[0]]).toEqual([SINGULAR.text, SINGULAR.text]);
    expect(inches[1]).toMatch(/\b3\.9 in\b/);
    expect(si[1]).toMatch(/\b10 cm\b/);
  });

  it('keeps its level and its place among the lamps', () => {
    const frame = frameOf('ORB UNL', [CLEARANCE, SINGULAR], NEAREST);
    const lamps = inUnits({ frame, units: INCHES });
    expect(lamps.map(({ name, level }) => [name, level])).toEqual([
      ['CLEARANCE', 'warning'],
      ['SINGULAR', 'caution'],
    ]);
  });

  it('keeps its text without a monitored pair', () => {
    expect(text(frameOf('ORB UNL', [CLEARANCE]), INCHES)).toEqual([CLEARANCE.text]);
  });
});

test('the view names the operator; only the page in control moves the orbiter with its sticks', () => {
  const { control, parts, readouts } = desk();
  const frame = frameOf('ORB UNL', []);
  expect(readouts.viewOf(frame)).toMatchObject({ flier: 'Anna', flying: true, orbiting: true });
  parts.operator.sticks.flyingOrbiter = false;
  expect(readouts.viewOf(frame)).toMatchObject({ flying: true, orbiting: false });
  parts.operator.sticks.flyingOrbiter = true;
  control.role = { ...control.role, flying: false, flier: 1 };
  expect(readouts.viewOf(frame)).toMatchObject({ flier: 'Page 1', flying: false, orbiting: false });
  control.role = { ...control.role, flier: 0 };
  expect(readouts.viewOf(frame).flier).toBe('');
});

test('the spine shows the lamps of the frame, then the lamps of the page', () => {
  const { parts, shown, show } = desk();
  parts.log.refusedAt = 9000;
  show(frameOf('ORB UNL', [SINGULAR, CLEARANCE]));
  expect(shown[0]?.lamps.map(({ name }) => name)).toEqual(['SINGULAR', 'CLEARANCE', 'CHECK CRT']);
});

test('a caution of the arm or the page shows the parts that it needs; an information does not', () => {
  const { parts, show } = desk();
  const info: Lamp = { name: 'RATE LIM', level: 'info', text: 'elbow', standing: false };
  parts.log.refusedAt = 9000;
  show(frameOf('ORB UNL', [SINGULAR, info]));
  const [, shown] = parts.calm.values.mock.calls[0] ?? [];
  expect(shown).toMatchObject({ lamps: ['SINGULAR', 'CHECK CRT'] });
});

test('a page too narrow for the controls has no lamp for its controllers', () => {
  const { control, controllers, shown, show } = desk();
  controllers.lost = [{ short: 'pad' }];
  show(frameOf('ORB UNL', []));
  control.tooNarrow = true;
  show(frameOf('ORB UNL', []));
  expect(shown.map(({ lamps }) => lamps.map(({ name }) => name))).toEqual([['CONTROLLER'], []]);
});

test('the sounds receive every frame', () => {
  const { parts, show } = desk();
  const frame = frameOf('ORB UNL', []);
  show(frame);
  expect(parts.sounds.update.mock.calls).toEqual([[frame]]);
});

test('only the page in control reports its cameras', () => {
  const { control, report, show } = desk();
  show(frameOf('ORB UNL', []), 7000);
  expect(report.mock.calls).toEqual([[20, [['A'], ['B']], 7000]]);
  control.role = { ...control.role, flying: false };
  show(frameOf('ORB UNL', []), 9000);
  expect(report).toHaveBeenCalledTimes(1);
});

test('only the mode TEST lights all lamps and segments', () => {
  const querySelectorAll = vi.fn(() => []);
  vi.stubGlobal('document', { querySelectorAll });
  const { shown, show } = desk();
  show(frameOf('ORB UNL', []));
  expect(querySelectorAll).not.toHaveBeenCalled();
  show(frameOf('TEST', []));
  expect(querySelectorAll).toHaveBeenCalledTimes(1);
  expect(shown.map(({ test: lit }) => lit)).toEqual([false, true]);
});

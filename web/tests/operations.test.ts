import { afterEach, describe, expect, it, test, vi } from 'vitest';
import type { Action } from '../src/input/action';
import type { AutopilotName, ModeInfo, Rate } from '../src/link/protocol';
import type { Command } from '../src/link/socket';
import { Operations } from '../src/page/operations';
import type { Parts } from '../src/page/parts';
import { LAMPS } from '../src/panel/spine/lamps';

afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

type Mode = Pick<ModeInfo, 'position' | 'kind'>;

const MODES = [
  { position: 'ORB UNL', kind: 'manual' },
  { position: 'MASTER', kind: 'master' },
] as readonly Mode[];

/**
 * A page of the operator, or of an observer if `flying` is false. It displays `frame`; its `parts` record their calls.
 */
function station(flying = true, payloads = 1) {
  const display: { autopilot: AutopilotName | null } = { autopilot: null };
  const frame = { mode: 'ORB UNL', rate: 'coarse' as Rate, display };
  const sticks = { flyingOrbiter: false, flyOrbiter: vi.fn() };
  const sheet = () => ({ open: vi.fn(), close: vi.fn(), toggle: vi.fn() });
  const parts = {
    welcome: { modes: MODES, work: { cargo: Array.from({ length: payloads }, () => ({})) } },
    control: { role: { flying } },
    arrivals: { telemetry: frame as typeof frame | null },
    log: { say: vi.fn(), keepTo: vi.fn() },
    operator: { flying, sticks, controllers: { acknowledge: vi.fn() } },
    spine: { element: {}, acknowledge: vi.fn() },
    groups: { meetMaster: vi.fn(), setPlane: vi.fn(), mode: { turnJoint: vi.fn() } },
    pictures: {
      togglePlane: vi.fn(() => true),
      matrix: { open: vi.fn(), close: vi.fn() },
      monitors: { step: vi.fn(), takeOther: vi.fn(), chooseDigit: vi.fn() },
    },
    windows: { update: vi.fn() },
    units: { toggle: vi.fn() },
    calm: { use: vi.fn() },
    light: { toggle: vi.fn(), lock: vi.fn() },
    ...{ keys: sheet(), sheet: sheet(), rail: sheet(), controlPage: sheet(), console: sheet() },
  };
  const sent: Command[] = [];
  const classes = new Set<string>();
  const clearance = {};
  const root = {
    querySelector: () => clearance,
    classList: {
      contains: (name: string) => classes.has(name),
      toggle: (name: string, on: boolean) => (on ? classes.add(name) : classes.delete(name)),
    },
  };
  const operations = new Operations(root as unknown as HTMLElement, parts as unknown as Parts, (command) =>
    sent.push(command),
  );
  return { frame, parts, sent, classes, clearance, operations };
}

test('a command of the operator is sent; a command of an observer is logged as rejected', () => {
  const operator = station();
  operator.operations.send({ type: 'rate_hold' });
  expect(operator.sent).toEqual([{ type: 'rate_hold' }]);
  expect(operator.parts.log.say).not.toHaveBeenCalled();
  const observer = station(false);
  observer.operations.send({ type: 'rate_hold' });
  expect(observer.sent).toEqual([]);
  expect(observer.parts.log.say).toHaveBeenCalledTimes(1);
});

describe('STOP', () => {
  it('is sent by the operator alone', () => {
    const operator = station();
    operator.operations.stop();
    expect(operator.sent).toEqual([{ type: 'stop' }]);
    const observer = station(false);
    observer.operations.stop();
    expect(observer.sent).toEqual([]);
  });

  it.each([
    ['MASTER', 1],
    ['ORB UNL', 0],
  ])('in %s sets the master arm to the arm’s angles; number of calls: %i', (mode, times) => {
    const { frame, operations, parts } = station();
    frame.mode = mode;
    operations.stop();
    expect(parts.groups.meetMaster).toHaveBeenCalledTimes(times);
  });

  it('is sent before the first frame', () => {
    const { operations, parts, sent } = station();
    parts.arrivals.telemetry = null;
    operations.stop();
    expect(sent).toEqual([{ type: 'stop' }]);
  });
});

test.each<[Rate, Rate]>([
  ['coarse', 'vernier'],
  ['vernier', 'coarse'],
])('the key of the rate changes %s to %s', (from, to) => {
  const { frame, operations, sent } = station();
  frame.rate = from;
  operations.act({ name: 'rate' });
  expect(sent).toEqual([{ type: 'select_rate', rate: to }]);
});

test('the keys of the joints select the next and the previous joint', () => {
  const { operations, parts } = station();
  operations.act({ name: 'joint +' });
  operations.act({ name: 'joint -' });
  expect(parts.groups.mode.turnJoint.mock.calls).toEqual([[1], [-1]]);
});

test('the keys of the cameras act on the monitors', () => {
  const { operations, parts } = station();
  const { monitors } = parts.pictures;
  operations.act({ name: 'cameraStep +' });
  operations.act({ name: 'otherMonitor' });
  operations.act({ name: 'camera 1' });
  expect(monitors.step.mock.calls).toEqual([[1]]);
  expect(monitors.takeOther).toHaveBeenCalledTimes(1);
  expect(monitors.chooseDigit.mock.calls.map(([index]) => index)).toEqual([0]);
});

describe('the THC', () => {
  it('moves the orbiter and then the arm again', () => {
    const { operations, parts } = station();
    const { sticks } = parts.operator;
    operations.act({ name: 'fly orbiter' });
    sticks.flyingOrbiter = true;
    operations.act({ name: 'fly orbiter' });
    expect(sticks.flyOrbiter.mock.calls).toEqual([[true], [false]]);
  });

  it('moves the arm in a worksite without a payload', () => {
    const { operations, parts } = station(true, 0);
    operations.flyOrbiter(true);
    expect(parts.operator.sticks.flyOrbiter.mock.calls).toEqual([[false]]);
  });

  it('of an observer is not assigned', () => {
    const { operations, parts } = station(false);
    operations.flyOrbiter(true);
    expect(parts.operator.sticks.flyOrbiter).not.toHaveBeenCalled();
    expect(parts.log.say).toHaveBeenCalledTimes(1);
  });
});

test('camera switches have an effect for an operator while no autopilot flies', () => {
  const barred = (flying: boolean, autopilot: AutopilotName | null) => {
    const { frame, operations } = station(flying);
    frame.display.autopilot = autopilot;
    return operations.cameraBar() !== '';
  };
  expect([barred(true, null), barred(true, 'script'), barred(true, 'policy')]).toEqual([false, true, true]);
  expect([barred(false, null), barred(false, 'script')]).toEqual([true, true]);
});

test('the sheet of controllers replaces the key map', () => {
  const { operations, parts } = station();
  operations.openControllers();
  expect(parts.keys.close).toHaveBeenCalledTimes(1);
  expect(parts.sheet.open).toHaveBeenCalledTimes(1);
});

test.each([true, false])('desk and secondary windows follow the separating plane: %s', (on) => {
  const { operations, parts } = station();
  parts.pictures.togglePlane.mockReturnValue(on);
  operations.act({ name: 'plane' });
  expect(parts.groups.setPlane.mock.calls).toEqual([[on]]);
  expect(parts.windows.update).toHaveBeenCalledTimes(1);
});

test('secondary windows follow the units', () => {
  const { operations, parts } = station();
  operations.changeUnits();
  expect(parts.units.toggle).toHaveBeenCalledTimes(1);
  expect(parts.windows.update).toHaveBeenCalledTimes(1);
});

test('clearance and lamps move to the view of all cameras until it closes', () => {
  const { classes, clearance, operations, parts } = station();
  const { matrix } = parts.pictures;
  operations.showMatrix(true);
  expect(matrix.open.mock.calls).toEqual([[clearance, parts.spine.element]]);
  expect([...classes]).toEqual(['all-cameras']);
  operations.showMatrix(false);
  expect(matrix.close).toHaveBeenCalledTimes(1);
  expect(classes.size).toBe(0);
});

test('one action acknowledges lamps and lost devices', () => {
  const { operations, parts } = station(false);
  operations.act({ name: 'acknowledge' });
  expect(parts.operator.controllers.acknowledge).toHaveBeenCalledTimes(1);
  expect(parts.spine.acknowledge).toHaveBeenCalledTimes(1);
});

test('Escape closes every sheet', () => {
  vi.stubGlobal('HTMLElement', class {});
  vi.stubGlobal('document', { activeElement: null });
  const { operations, parts } = station();
  operations.act({ name: 'leave' });
  for (const { close } of [parts.keys, parts.sheet, parts.rail, parts.controlPage, parts.console])
    expect(close).toHaveBeenCalledTimes(1);
});

test.each<[Action['name'] & ('stop' | 'rate hold'), Command['type']]>([
  ['stop', 'stop'],
  ['rate hold', 'rate_hold'],
])('the key of %s sends the command %s', (name, type) => {
  const { operations, sent } = station();
  operations.act({ name });
  expect(sent).toEqual([{ type }]);
});

test('a pressed lamp filters the log by its kinds and outlines its elements for 2 s', () => {
  vi.useFakeTimers();
  const outlined = new Set<string>();
  const element = {
    classList: {
      add: (name: string) => outlined.add(name),
      remove: (name: string) => outlined.delete(name),
    },
  };
  vi.stubGlobal('document', {
    querySelectorAll: (selector: string) => (selector === LAMPS['SOFT STOP'].elements ? [element] : []),
  });
  const { operations, parts } = station();
  operations.explain('SOFT STOP');
  expect(parts.log.keepTo.mock.calls).toEqual([['SOFT STOP', LAMPS['SOFT STOP'].kinds]]);
  vi.advanceTimersByTime(1999);
  expect(outlined.size).toBe(1);
  vi.advanceTimersByTime(1);
  expect(outlined.size).toBe(0);
});

test.each([
  ['opens', {}, 0],
  ['is blocked', null, 1],
])('a secondary window that %s (the browser returns %s) adds %i lines to the log', (_, opened, times) => {
  vi.stubGlobal('location', { href: 'http://station/?quality=low' });
  const open = vi.fn((_address: URL) => opened);
  vi.stubGlobal('window', { open, addEventListener() {} });
  const { operations, parts } = station();
  operations.tearOff('matrix');
  expect(parts.log.say).toHaveBeenCalledTimes(times);
  const { searchParams } = open.mock.calls[0]?.[0] ?? new URL('http://none/');
  expect([searchParams.get('view'), searchParams.get('quality')]).toEqual(['matrix', 'low']);
});

import { expect, test } from 'vitest';
import { KEYS } from '../src/input/active-device';
import { Latency } from '../src/link/latency';
import type { Frame, JointInfo } from '../src/link/protocol';
import { parse } from '../src/link/socket';
import { isSoftware } from '../src/page/quality';
import { together } from '../src/panel/controllers/key-map';
import { leadsAway } from '../src/panel/desk/limits';
import { limitTags, pointWords } from '../src/panel/desk/resolution';
import { opposite } from '../src/panel/desk/thc';
import { BAR, place } from '../src/panel/joints/joint-scale';
import { stickToPicture } from '../src/panel/monitors/axes';
import { leaving } from '../src/panel/rail/scenarios';
import { segments } from '../src/panel/spine/lamp-test';
import { whatNext } from '../src/panel/target/route';
import { firstShown, startPoint } from '../src/panel/target/stored-points';
import { unitsOf } from '../src/words/units';

const joint = { hard: [-180, 180], soft: [-177.4, 177.4], reach: [-175.4, 175.4] } as const;

test('a joint bar is linear between the reach limits, its zones have one width', () => {
  expect(place(joint, 0)).toBeCloseTo(BAR / 2);
  expect(place(joint, -175.4)).toBeCloseTo(18);
  expect(place(joint, 87.7)).toBeCloseTo(BAR / 2 + (BAR - 36) / 4);
  expect(place(joint, 177.4)).toBeCloseTo(BAR - 9);
  expect(place(joint, 180)).toBe(BAR);
  expect(place(joint, -200)).toBe(0);
});

test('latency runs from the input to the first picture that has flown it', () => {
  const latency = new Latency();
  latency.sent(5, 100);
  latency.drawn(4, 120);
  expect(latency.percentile95(120)).toBeNull();
  latency.drawn(6, 150);
  expect(latency.percentile95(150)).toBe(50);
  latency.drawn(7, 300);
  expect(latency.percentile95(300)).toBe(50);
  expect(latency.percentile95(10_151)).toBeNull();
});

test('latency shows the 95th percentile', () => {
  const latency = new Latency();
  for (let i = 1; i <= 100; i += 1) {
    latency.sent(i, 0);
    latency.drawn(i, i);
  }
  expect(latency.percentile95(100)).toBe(95);
});

test('a connection lost takes along what was on its way', () => {
  const latency = new Latency();
  latency.sent(1, 0);
  latency.forget();
  latency.drawn(1, 50);
  expect(latency.percentile95(50)).toBeNull();
});

test('sticks and picture agree where +X goes into the picture, +Y right, +Z down', () => {
  expect(
    stickToPicture([
      [0, 0, -1],
      [1, 0, 0],
      [0, -1, 0],
    ]),
  ).toBeCloseTo(0);
  expect(
    stickToPicture([
      [0, 0, 1],
      [-1, 0, 0],
      [0, -1, 0],
    ]),
  ).toBeCloseTo(Math.PI);
});

test('the other end of an axis carries the opposite word', () => {
  expect(opposite('+X fwd')).toBe('−X aft');
  expect(opposite('+Z down')).toBe('−Z up');
  expect(opposite('+X')).toBe('−X');
});

test('inches and feet per second, or SI', () => {
  expect(unitsOf('ft-in').length.perSi * 0.0254).toBeCloseTo(1);
  expect(unitsOf('ft-in').speed.perSi * 0.3048).toBeCloseTo(1);
  expect(unitsOf('SI').length.perSi).toBe(1);
});

test.each([
  ['ANGLE (Mesa, llvmpipe (LLVM 15.0.6 256 bits), OpenGL 4.5)', true],
  ['ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)), SwiftShader driver)', true],
  ['ANGLE (NVIDIA, NVIDIA GeForce RTX 3060 Direct3D11)', false],
])('%s is software drawing: %s', (renderer, software) => {
  expect(isSoftware(renderer)).toBe(software);
});

test('a message of an unknown type is refused by name', () => {
  expect(parse('{"type":"refused","seq":-1,"text":"No."}')).toMatchObject({ seq: -1 });
  expect(() => parse('{"type":"rumour"}')).toThrow('rumour');
  expect(() => parse(new ArrayBuffer(1))).toThrow('not text');
});

test('a joint past a limit is told what leads away, its name once', () => {
  const way = {
    cause: 'elbow_pitch',
    stick: 'translation',
    axis: 2,
    sign: 1,
    position: '',
    text: '',
  } as const;
  expect(leadsAway(way, KEYS)).toBe('Elbow pitch: THC +Z (E) leads away');
  const single = { ...way, stick: 'joint', sign: -1, position: 'SINGLE' } as const;
  expect(leadsAway(single, KEYS)).toBe('Elbow pitch: SINGLE − leads away');
});

test.each([
  ['−12.5', '±888.8'],
  ['356.5', '888.8'],
  ['−1282.5', '±8888.8'],
  ['+0.05', '±8.88'],
  ['000/03:42:17', '888/88:88:88'],
  ['–', '–'],
])('in TEST, %s is lit as %s', (shown, lit) => {
  expect(segments(shown)).toBe(lit);
});

const still = { velocity: [0, 0, 0], turn_rate: [0, 0, 0] };
const moving = { velocity: [0.1, -0.3, 0], turn_rate: [0, 0, 0.01] };
const named: readonly JointInfo[] = [{ label: 'Sho yaw' }, { label: 'Sho pitch' }] as never;

function frameOf(parts: object): Frame {
  const display = { actual: still, commanded: moving };
  return { limits: [], por_limits: [0.6, 0.08], display, ...parts } as never;
}

test('a limit is named beside the bar of the axis that feels it', () => {
  const joint = frameOf({ limits: [{ kind: 'joint rate', joint: 1, text: '' }] });
  expect(limitTags(joint, named)[1]).toEqual({ text: 'Sho pitch', caution: true });
  const turning = frameOf({ limits: [{ kind: 'POR rotation', joint: -1, text: '' }] });
  expect(limitTags(turning, named)[5]).toEqual({ text: 'POR most', caution: false });
  const building = frameOf({ limits: [{ kind: 'POR acceleration', joint: -1, text: '' }] });
  expect(limitTags(building, named)[1]).toEqual({ text: 'POR accel', caution: false });
});

test('a joint takes the place of the point’s own limit', () => {
  const both = [
    { kind: 'joint rate', joint: 0, text: '' },
    { kind: 'POR translation', joint: -1, text: '' },
  ];
  expect(limitTags(frameOf({ limits: both }), named)[1]).toEqual({ text: 'Sho yaw', caution: true });
});

test('the title says which point moves along which axes', () => {
  const loaded = { kind: 'manual', point: 'payload', axes: 'orbiter axes' } as never;
  expect(pointWords(loaded, frameOf({ law: 4 }), named)).toBe('payload, orbiter axes');
  expect(pointWords(loaded, frameOf({ law: 7 }), named)).toBe('payload; turns in payload axes');
  expect(pointWords({ kind: 'single' } as never, frameOf({ joint: 1 }), named)).toBe('tip; sho pitch moves');
});

test('AUTO says what PROCEED would do', () => {
  const at = (parts: object) =>
    whatNext(frameOf({ points: 4, point: 1, sequence: 'ready', goal: {}, ...parts }));
  expect(at({})).toContain('starts');
  expect(at({ sequence: 'in progress' })).toContain('pause point');
  expect(at({ point: 4 })).toContain('continues');
  expect(at({ point: 4, sequence: 'idle', goal: null })).toContain('complete');
  expect(at({ point: 2, sequence: 'idle', check: { good: false, text: '' } })).toContain('clear');
});

test('names that begin alike are told together', () => {
  expect(together([])).toBe('');
  expect(together(['North'])).toBe('North');
  expect(together(['Menu + Cross ↓', 'Menu + Cross ↑'])).toBe('Menu + Cross ↓ ↑');
  expect(together(['Menu + North', 'Menu + Cross ↑'])).toBe('Menu + North Cross ↑');
  expect(together(['North', 'Menu + North'])).toBe('North, Menu + North');
});

test('of many stored points the next one is in sight, with the one before it', () => {
  expect(firstShown(1, 4)).toBe(0);
  expect(firstShown(1, 12)).toBe(0);
  expect(firstShown(6, 12)).toBe(4);
  expect(firstShown(12, 12)).toBe(7);
  expect(firstShown(0, 0)).toBe(0);
});

test('a sequence starts at its next point, and from the first where it is complete or not entered', () => {
  expect(startPoint('AUTO 1', { mode: 'AUTO 1', point: 3 }, 4)).toBe(3);
  expect(startPoint('AUTO 1', { mode: 'AUTO 1', point: 5 }, 4)).toBe(1);
  expect(startPoint('AUTO 2', { mode: 'AUTO 1', point: 3 }, 2)).toBe(1);
  expect(startPoint('AUTO 3', { mode: 'AUTO 1', point: 3 }, 0)).toBe(0);
});

test('leaving a flight says what is kept of it', () => {
  expect(leaving('First flight', 'Tutorial', true)).toBe(
    'Leave “First flight” for “Tutorial”? Its recording is complete and kept.',
  );
  expect(leaving('First flight', 'Tutorial', false)).toContain('not recorded');
});

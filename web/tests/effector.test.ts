import { expect, test } from 'vitest';
import type { Cargo, Frame } from '../src/link/protocol';
import { whereIs } from '../src/panel/effector/cargo';
import { graspWords } from '../src/panel/effector/effector';
import { isMoving as onItsWay } from '../src/panel/effector/prong';
import { seatNow } from '../src/panel/effector/seat';
import { SI } from './worksite';

const CARGO = { name: 'payload', held: false, seat: '' } as Cargo;

test('a payload is captured, berthed, both, or free', () => {
  expect(whereIs(false, '')).toBe('free');
  expect(whereIs(false, 'Cargo bay')).toBe('Cargo bay');
  expect(whereIs(true, '')).toBe('held');
  expect(whereIs(true, 'Cargo bay')).toBe('held, fixed');
});

test('the end effector shows its payload and speed limit', () => {
  const payloads = [
    { id: 0, mass: 0, translation: [0.6, 0.1] },
    { id: 2, mass: 1000, translation: [0.06, 0.03] },
  ] as const;
  const words = (cargo: readonly Cargo[], rate: Frame['rate'] = 'coarse') =>
    graspWords({ work: { cargo }, display: { payload_id: 2 }, rate }, payloads, SI);
  const beacon = { ...CARGO, name: 'beacon', held: true };
  expect(words([CARGO, beacon])).toBe('beacon, 1000 kg, max 0.060 m/s');
  expect(words([CARGO, beacon], 'vernier')).toBe('beacon, 1000 kg, max 0.030 m/s');
  expect(words([CARGO])).toBe('empty, max 0.060 m/s');
  expect(words([CARGO], 'vernier')).toBe('empty, max 0.030 m/s');
  expect(words([])).toBe('');
});

test('the prong moves until it reaches its commanded position', () => {
  expect(onItsWay({ switch: 'stop', opening: 0.4 })).toBe(false);
  expect(onItsWay({ switch: 'close', opening: 0.4 })).toBe(true);
  expect(onItsWay({ switch: 'close', opening: 0 })).toBe(false);
  expect(onItsWay({ switch: 'open', opening: 0 })).toBe(true);
  expect(onItsWay({ switch: 'open', opening: 1 })).toBe(false);
});

test('the latch row is for the captured payload, or else for the berthed payload', () => {
  const seated = { ...CARGO, seat: 'bay' };
  expect(seatNow({ cargo: [seated, { ...CARGO, held: true }] })).toBe('');
  expect(seatNow({ cargo: [CARGO, seated] })).toBe('bay');
});

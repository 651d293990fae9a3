import { expect, test } from 'vitest';
import type { Ahead } from '../src/link/protocol';
import { about, next, words } from '../src/panel/desk/look-ahead';
import { unitsOf } from '../src/words/units';

const joints = ['Sho yaw', 'Sho pitch', 'Elbow', 'Wri pitch', 'Wri yaw', 'Wri roll'].map((label) => ({
  label,
  slides: false,
}));
const ahead: Ahead = {
  seconds: 5,
  held: true,
  moves: true,
  clearance: 0.254,
  a: 'lower boom',
  b: 'bay wall port',
  contact_s: null,
  stopping: 0.127,
  joint: 2,
  room: Math.PI / 18,
  poses: [],
};

test('distances and angles are in the operator’s units', () => {
  expect(words(ahead, joints, unitsOf('ft-in'))).toEqual({
    clearance: '10 in',
    between: 'lower boom to bay wall port',
    stopping: '5.0 in',
    joint: 'Elbow 10°',
  });
  expect(words(ahead, joints, unitsOf('SI')).clearance).toBe('25 cm');
});

test('a predicted contact is named, and so is a joint past its limit', () => {
  const told = words({ ...ahead, contact_s: 3.04, room: -0.0175 }, joints, unitsOf('SI'));
  expect(told.clearance).toBe('contact 3.0 s');
  expect(told.joint).toBe('Elbow 1° past');
  expect(words({ ...ahead, clearance: null }, joints, unitsOf('SI')).clearance).toBe('–');
});

test('a joint that slides has a length to its limit', () => {
  const rail = [{ label: 'Rail', slides: true }];
  expect(words({ ...ahead, joint: 0, room: 5.3 }, rail, unitsOf('SI')).joint).toBe('Rail 5.30 m');
  expect(words({ ...ahead, joint: 0, room: -0.05 }, rail, unitsOf('ft-in')).joint).toBe('Rail 2.0 in past');
});

test('the label names the stick command of the prediction', () => {
  expect(about({ held: true, moves: true })).toBe('deflected');
  expect(about({ held: false, moves: true })).toBe('last axis');
  expect(about({ held: false, moves: false })).toBe('centred');
});

test('the look-ahead time cycles from 2 to 20 s', () => {
  expect([2, 5, 10, 20, 12].map(next)).toEqual([5, 10, 20, 2, 20]);
});

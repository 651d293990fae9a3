import { expect, test } from 'vitest';
import type { JointInfo } from '../src/link/protocol';
import { limitTags, pointWords } from '../src/panel/desk/resolution';
import { frameOf } from './panel-frames';

const named: readonly JointInfo[] = [{ label: 'Sho yaw' }, { label: 'Sho pitch' }] as never;

test('an active limit is named at the bar of the axis that it limits', () => {
  const joint = frameOf({ limits: [{ kind: 'joint rate', joint: 1, text: '' }] });
  expect(limitTags(joint, named)[1]).toEqual({ text: 'Sho pitch', caution: true });
  const turning = frameOf({ limits: [{ kind: 'POR rotation', joint: -1, text: '' }] });
  expect(limitTags(turning, named)[5]).toEqual({ text: 'POR max', caution: false });
  const building = frameOf({ limits: [{ kind: 'POR acceleration', joint: -1, text: '' }] });
  expect(limitTags(building, named)[1]).toEqual({ text: 'POR accel', caution: false });
});

test('a joint limit is named in place of a POR limit', () => {
  const both = [
    { kind: 'joint rate', joint: 0, text: '' },
    { kind: 'POR translation', joint: -1, text: '' },
  ];
  expect(limitTags(frameOf({ limits: both }), named)[1]).toEqual({ text: 'Sho yaw', caution: true });
});

test('the title names the point that moves and its axes', () => {
  const loaded = { kind: 'manual', point: 'payload', axes: 'orbiter axes' } as never;
  expect(pointWords(loaded, frameOf({ law: 4 }), named)).toBe('payload, orbiter axes');
  expect(pointWords(loaded, frameOf({ law: 7 }), named)).toBe('payload; turns in payload axes');
  expect(pointWords({ kind: 'single' } as never, frameOf({ joint: 1 }), named)).toBe('tip; sho pitch moves');
});

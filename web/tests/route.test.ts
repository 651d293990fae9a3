import { expect, test } from 'vitest';
import { whatNext } from '../src/panel/target/route';
import { frameOf } from './panel-frames';

test('AUTO names the effect of PROCEED', () => {
  const at = (parts: object) =>
    whatNext(frameOf({ points: 4, point: 1, sequence: 'ready', goal: {}, ...parts }));
  expect(at({})).toContain('starts');
  expect(at({ sequence: 'in progress' })).toContain('pause point');
  expect(at({ point: 4 })).toContain('continues');
  expect(at({ point: 4, sequence: 'idle', goal: null })).toContain('complete');
  expect(at({ point: 2, sequence: 'idle', check: { good: false, text: '' } })).toContain('clear');
});

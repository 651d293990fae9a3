import { expect, test } from 'vitest';
import type { ModeInfo, StepInfo } from '../src/link/protocol';
import { situationNeeds, stepNeeds, useNeeds } from '../src/panel/calm/needs';

const STEP: StepInfo = {
  title: 'Step',
  text: '',
  mode: null,
  uses: [],
  groups: [],
  cameras: [],
  hints: [],
};
const AT_REST = { lamps: [], modes: [], cameras: [], holding: false, orbiting: false };
const mode = (position: string, kind: ModeInfo['kind']) => ({ position, kind }) as ModeInfo;

test('a step needs its groups, mode, cameras and functions, and the groups of its functions', () => {
  const uses = [
    { use: 'close', does: '' },
    { use: 'rate hold', does: '' },
  ] as const;
  const needs = stepNeeds({ ...STEP, uses, groups: ['thc'], mode: 'PL', cameras: ['A', 'WR'] });
  expect(needs).toEqual(
    expect.arrayContaining(['thc', 'mode PL', 'camera A', 'camera WR', 'close', 'effector', 'rate hold']),
  );
});

test('a step needs the parts that its text or a hint quotes', () => {
  const hints = [{ text: 'Read *LOOK AHEAD*.', uses: [] }];
  const needs = stepNeeds({ ...STEP, text: 'Watch *WR* in *END EFF*.', hints });
  expect(needs).toEqual(expect.arrayContaining(['camera WR', 'mode END EFF', 'look ahead']));
});

test('a function whose key is pressed needs its group', () => {
  expect(useNeeds('close')).toContain('effector');
  expect(useNeeds('bending')).toContain('joints');
  expect(useNeeds('rate hold')).toContain('rate hold');
});

test('functions of a hint count as those of the step', () => {
  const hints = [{ text: '', uses: [{ use: 'brakes', does: '' }] }] as const;
  expect(stepNeeds({ ...STEP, hints })).toContain('brakes');
});

test('a lit lamp needs the group that shows its cause, and a limit of the arm also the escape directions', () => {
  expect(situationNeeds({ ...AT_REST, lamps: ['SINGULAR'] })).toEqual(['singularity', 'limits']);
  expect(situationNeeds({ ...AT_REST, lamps: ['CHECK CRT'] })).toEqual(['events']);
  expect(situationNeeds({ ...AT_REST, lamps: ['LINK DELAY'] })).toContain('delays');
  expect(situationNeeds({ ...AT_REST, lamps: ['CLEARANCE'] })).toContain('clearance');
});

test('modes, cameras and a held payload need their parts', () => {
  const modes = [mode('SINGLE', 'single'), mode('AUTO 1', 'automatic'), undefined];
  const needs = situationNeeds({ ...AT_REST, modes, cameras: ['B'], holding: true, orbiting: true });
  expect(new Set(needs)).toEqual(
    new Set(['proceed', 'joints', 'mode SINGLE', 'mode AUTO 1', 'camera B', 'effector', 'fly orbiter']),
  );
  expect(situationNeeds(AT_REST)).toEqual([]);
});

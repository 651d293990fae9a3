import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { PlaybackIndex } from '../src/link/protocol';
import { replayRail } from '../src/replay/rail';
import { small, useSmallPage } from './small-page';

beforeEach(useSmallPage);

afterEach(() => {
  vi.unstubAllGlobals();
});

const WELCOME = {
  command_delay_s: 0,
  telemetry_delay_s: 0,
  camera_delay_s: 0,
  title: 'First flight',
  text: '',
};
const INDEX = {
  ...{ welcome: WELCOME, file: 'flight.mcap', began: '2026-03-01T14:05:00Z', version: '0.2.0', seed: 1 },
  ...{ changes: [], participant: '', condition: '', period_s: 0.02, stride: 1, ended: 'time is up' },
} as unknown as PlaybackIndex;

/** Text and tooltip of each fact with a long text. */
function words(parts: Partial<PlaybackIndex>) {
  const { element } = replayRail({ ...INDEX, ...parts }, null, () => {});
  return small(element)
    .all.filter(({ classes }) => classes.includes('words'))
    .map((fact) => [fact.textContent, fact.getAttribute('title')]);
}

test('the rail has the participant and the condition, with the whole text in the tooltip', () => {
  const condition = 'command delay 2 s, wrist camera off, second of three sessions, orbiter axes first';
  expect(words({ participant: 'P07', condition })).toEqual([
    ['Participant P07', 'P07'],
    [`Condition ${condition}`, condition],
  ]);
});

test('a recording without participant and condition has neither in the rail', () => {
  expect(words({})).toEqual([]);
});

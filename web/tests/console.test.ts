import { expect, test } from 'vitest';
import { renew } from '../src/link/changed';
import type { Changed, Welcome } from '../src/link/protocol';
import { common, completed, History } from '../src/panel/console/history';
import { FlownChanges } from '../src/replay/flown-changes';

test.each([
  [['limits.por.translation', 'limits.por.rotation'], 'limits.por.'],
  [['print'], 'print'],
  [['set', 'print'], ''],
  [[], ''],
])('the words %j begin with %j', (words, beginning) => {
  expect(common(words)).toBe(beginning);
});

test.each([
  ['set lim', 'limits', 'set limits'],
  ['set a = 1; b', 'bay', 'set a = 1; bay'],
  ['pr', 'print', 'print'],
  ['print ', 'limits', 'print limits'],
])('the last word of %j becomes %j', (line, word, whole) => {
  expect(completed(line, word)).toBe(whole);
});

test('the arrow keys bring back the lines typed before, and then an empty line', () => {
  const history = new History();
  expect(history.step(-1)).toBe('');
  for (const line of ['help', 'changes', 'changes', '']) history.add(line);
  expect([history.step(-1), history.step(-1), history.step(-1)]).toEqual(['changes', 'help', 'help']);
  expect([history.step(1), history.step(1), history.step(1)]).toEqual(['changes', '', '']);
});

test('parts that hold an object of the welcome see its new fields', () => {
  const joint = { name: 'elbow', hard: [0, 1] };
  const welcome = { title: 'flight', joints: [joint], work: { caution: 0.5 }, singular: 0.2 };
  const changed = { type: 'changed', joints: [{ name: 'elbow', hard: [0, 2] }], work: { caution: 0.9 } };
  renew(welcome as unknown as Welcome, changed as unknown as Changed);
  expect(joint.hard).toEqual([0, 2]);
  expect(welcome).toEqual({ title: 'flight', joints: [joint], work: { caution: 0.9 }, singular: 0.2 });
});

test('a replay sets the fields that are in force at the shown step, also backwards', () => {
  const fields = (caution: number) => ({ type: 'changed', work: { caution } }) as unknown as Changed;
  const welcome = { work: { caution: 0.5 } } as unknown as Welcome;
  const changed = [
    { tick: 0, fields: fields(0.5) },
    { tick: 10, fields: fields(0.9) },
  ];
  const flown = new FlownChanges({ welcome, changed });
  expect([5, 9, 10, 400, 3].map((tick) => [flown.show(tick), welcome.work.caution])).toEqual([
    [true, 0.5],
    [false, 0.5],
    [true, 0.9],
    [false, 0.9],
    [true, 0.5],
  ]);
});

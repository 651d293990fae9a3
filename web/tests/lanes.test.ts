import { expect, test } from 'vitest';
import { marksOf, stretchAt } from '../src/replay/lanes';

test('stretchAt returns the stretch at a time, also at its ends', () => {
  const stretch = (start_s: number, end_s: number) => ({ start_s, end_s, label: '', level: 'info' }) as const;
  const stretches = [stretch(0, 1), stretch(1, 5), stretch(5, 6)];
  expect([0.02, 1, 1.02, 5, 5.5, 6, 7].map((time) => stretchAt(stretches, time))).toEqual([
    0, 0, 1, 1, 2, 2, 2,
  ]);
});

test('captures and releases are marked once each', () => {
  const line = (time_s: number, kind: string) => ({ time_s, kind, level: 'info', text: kind }) as const;
  const events = [
    line(1, 'mode'),
    line(2, 'captured'),
    line(2, 'acquired'),
    line(9, 'released'),
    line(9, 'released'),
  ];
  expect(marksOf(events).map(({ time_s, name }) => [time_s, name])).toEqual([
    [2, 'captured'],
    [9, 'released'],
  ]);
});

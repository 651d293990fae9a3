import { expect, test } from 'vitest';
import { SituationWatch } from '../src/cameras/pair-offer';

test('a change of situation surveys every camera once; the first situation surveys none', () => {
  const watch = new SituationWatch(3);
  watch.see('acquisition');
  watch.see('acquisition');
  expect(watch.pending).toBe(false);
  watch.see('extraction');
  expect([1, 2, 3].map(() => watch.surveyed())).toEqual([false, false, true]);
  watch.see('extraction');
  expect(watch.pending).toBe(false);
});

test('a change during the surveys starts them again', () => {
  const watch = new SituationWatch(2);
  watch.see('acquisition');
  watch.see('extraction');
  watch.surveyed();
  watch.see('manoeuvring');
  expect([1, 2].map(() => watch.surveyed())).toEqual([false, true]);
});

import { expect, test } from 'vitest';
import { Offers } from '../src/cameras/offers';
import type { PairOffer } from '../src/cameras/pair-offer';

test('a pair is offered until it is shown, and a pair that is shown is not offered', () => {
  const shown: string[][] = [['A'], ['B']];
  const offers: (PairOffer | null)[] = [];
  const monitors = {
    shown,
    show(which: number, names: readonly string[]) {
      shown[which] = [...names];
    },
  };
  const all = new Offers({ cameras: [], steps: [] }, monitors, (offer) => offers.push(offer));
  const pair: PairOffer = { cameras: ['C', 'B'], why: 'extraction' };
  all.offer({ ...pair, cameras: ['B', 'A'] });
  all.offer(pair);
  all.take();
  all.take();
  all.offer(pair);
  expect(shown).toEqual([['C'], ['B']]);
  expect(offers).toEqual([null, pair, null, null, null]);
});

import { expect, test, vi } from 'vitest';
import { FLOWN, Tether } from '../src/windows/secondary-window';
import { small, useSmallPage } from './small-page';

test('a secondary window shows the time of its frame, and whether it is out of date', () => {
  useSmallPage();
  vi.stubGlobal('location', { search: '' });
  vi.stubGlobal('window', Object.assign(new EventTarget(), { setInterval: () => 0 }));
  Object.assign(document, { addEventListener() {}, removeEventListener() {} });
  const tether = new Tether({ ...FLOWN, name: 'MON 1', title: 'Flight' }, { heard() {} });
  const rail = (time_s: number, s: number) => {
    tether.showAt({ time_s }, { s, set: 2, undrawn: false });
    const shown = (selector: string) => small(tether.rail).querySelector(selector)?.textContent;
    return [shown('span.met b'), shown('span.who')];
  };
  expect(rail(2, 2.1)).toEqual(['000/00:00:02', FLOWN.alone]);
  expect(rail(3, 2.6)).toEqual(['000/00:00:03', 'Lost']);
  expect(rail(4, 2)).toEqual(['000/00:00:04', FLOWN.alone]);
  tether.dispose();
});

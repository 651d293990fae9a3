import { expect, test, vi } from 'vitest';
import { DelayLine } from '../src/link/delay-line';
import type { Frame } from '../src/link/protocol';
import { FLOWN, Tether } from '../src/windows/secondary-window';
import { small, useSmallPage } from './small-page';

test('a secondary window shows the time of the delayed frame, and whether it is out of date', () => {
  useSmallPage();
  vi.stubGlobal('location', { search: '' });
  vi.stubGlobal('window', Object.assign(new EventTarget(), { setInterval: () => 0 }));
  Object.assign(document, { addEventListener() {}, removeEventListener() {} });
  const tether = new Tether({ ...FLOWN, name: 'MON 1', title: 'Flight' }, { heard() {} });
  const line = new DelayLine(2);
  const rail = (now: number) => {
    line.displayed(now);
    tether.showDue(line, now);
    const shown = (selector: string) => small(tether.rail).querySelector(selector)?.textContent;
    return [shown('span.met b'), shown('span.who')];
  };
  const put = (time_s: number) => line.put({ frame: { tick: time_s, time_s } as Frame, at: 1000 * time_s });
  for (const time of [0, 1, 2, 3, 4]) put(time);
  expect(rail(4000)).toEqual(['000/00:00:02', FLOWN.alone]);
  expect(rail(5900)).toEqual(['000/00:00:03', 'Lost']);
  put(5.5);
  expect(rail(6000)).toEqual(['000/00:00:04', FLOWN.alone]);
  tether.dispose();
});

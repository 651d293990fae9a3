import { expect, test } from 'vitest';
import { Drawers, HIDDEN, LOST } from '../src/cameras/drawers';
import type { Drawer } from '../src/cameras/full-profile';

/** Drawers of which each has a number; `broken`: whether none can be made. */
function made() {
  const world = { broken: false, made: 0, former: [] as Drawer[] };
  const make = () => {
    if (world.broken) throw new Error('no WebGL');
    world.made += 1;
    return { number: world.made } as unknown as Drawer;
  };
  const drawers = new Drawers(make, (former) => world.former.push(former));
  return { world, drawers };
}

test('a drawer that failed is replaced after a second', () => {
  const { world, drawers } = made();
  const [first] = [drawers.present];
  expect(drawers.ready(0)).toBe(true);
  drawers.failed(LOST, 0);
  expect(drawers.fault).toBe(LOST);
  expect(drawers.ready(900)).toBe(false);
  expect(drawers.ready(1100)).toBe(true);
  expect(world.former).toEqual([first]);
  expect(drawers.fault).toBe(LOST); // until something is drawn
  drawers.drawn(true);
  expect(drawers.fault).toBe('');
});

test('attempts to make a drawer become rarer, and end with success', () => {
  const { world, drawers } = made();
  drawers.failed(new Error('a fault'), 0);
  expect(drawers.fault).toContain('a fault');
  world.broken = true;
  const attempts: number[] = [];
  let fault = '';
  for (let now = 0; now < 100_000; now += 50) {
    drawers.fault = '';
    expect(drawers.ready(now)).toBe(false);
    if (drawers.fault) attempts.push(now / 1000);
    fault = drawers.fault || fault;
  }
  expect(fault).toContain('no WebGL');
  expect(attempts).toEqual([1, 3, 7, 15, 31, 63, 95]);
  world.broken = false;
  expect(drawers.ready(200_000)).toBe(true);
  drawers.drawn(true);
  drawers.failed(LOST, 300_000);
  expect(drawers.ready(301_100)).toBe(true);
  expect(drawers.failures).toBe(2);
});

test('pictures that are hidden in the page are a fault until they are visible', () => {
  const { drawers } = made();
  drawers.drawn(false);
  expect([drawers.fault, drawers.ready(0)]).toEqual([HIDDEN, true]);
  drawers.drawn(true);
  expect(drawers.fault).toBe('');
});

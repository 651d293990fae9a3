import { beforeEach, expect, test, vi } from 'vitest';
import type { InHand } from '../src/input/active-device';
import { ZERO } from '../src/input/deflection';
import type { StepInfo, UseInfo, Vec3, Welcome } from '../src/link/protocol';
import { maySimplify, Opening, STARTED, thingToDo } from '../src/page/opening';
import type { View } from '../src/panel/parts/part';
import { small, useSmallPage } from './small-page';

const STEP: StepInfo = {
  ...{ title: 'Move', text: 'Push the stick.', mode: null, groups: [], cameras: [], hints: [] },
  uses: [{ use: '-Z', does: 'up' }],
};
const RUN = { steps: [STEP], phases: [] } as unknown as Welcome;
const HAND = { name: (use: string) => use, kinds: ['keyboard'] } as unknown as InHand;

/** What the shot changes outside its own element. */
let page: { classes: Set<string>; second: boolean; pressed: (() => void)[] };

beforeEach(() => {
  useSmallPage();
  page = { classes: new Set(), second: true, pressed: [] };
  const classList = {
    toggle: (name: string, on: boolean) => page.classes[on ? 'add' : 'delete'](name),
    contains: (name: string) => page.classes.has(name),
  };
  Object.assign(document, {
    body: { classList },
    addEventListener: (_: string, act: () => void) => page.pressed.push(act),
  });
  vi.stubGlobal('requestAnimationFrame', (act: () => void) => act());
});

function begun(kept: string | null = null, calm = true, welcome = RUN) {
  const store = { getItem: () => kept, setItem: vi.fn(() => true) };
  const first = { after: () => (page.second = true) };
  const second = { previousElementSibling: first, remove: () => (page.second = false) };
  const opening = new Opening(welcome, store, HAND, second as unknown as HTMLElement);
  opening.begin(calm);
  return { opening, store };
}

function view(changes: Partial<View> = {}, at = 0, level = 'info'): View {
  const display = { task: { at }, lamps: [{ level }] };
  return { frame: { display }, hand: ZERO, flying: true, ...changes } as unknown as View;
}

const isShot = () => page.classes.has('opening') && !page.second;

test('the shot is there at the first start on the calm page, and at no other', () => {
  begun();
  expect(isShot()).toBe(true);
  for (const other of [
    () => begun('yes'),
    () => begun(null, false),
    () => begun(null, true, { ...RUN, steps: [] }),
  ]) {
    page.classes.clear();
    page.second = true;
    other();
    expect(isShot()).toBe(false);
  }
});

test('the shot is never there where a step chooses the cameras or a script flies', () => {
  expect(maySimplify(RUN)).toBe(true);
  expect(maySimplify({ ...RUN, steps: [{ ...STEP, cameras: ['A', 'B'] }] })).toBe(false);
  expect(maySimplify({ ...RUN, phases: ['approach'] })).toBe(false);
});

test('any key ends the shot for good, and the second monitor comes back', () => {
  const { store } = begun();
  page.pressed[0]?.();
  expect(isShot()).toBe(false);
  expect(page.second).toBe(true);
  expect(store.setItem).toHaveBeenCalledExactlyOnceWith(STARTED, expect.any(String));
});

test('a stick, the second step, a warning and another operator end the shot; nothing else does', () => {
  const moved = ZERO.map((value, axis) => (axis === 0 ? 0.2 : value));
  const ends = [
    view({ hand: moved }),
    view({}, 1),
    view({}, 0, 'warning'),
    view({ flying: false, flier: 'Anna' }),
  ];
  for (const end of ends) {
    const { opening } = begun();
    opening.values(view(), false, true);
    expect(isShot()).toBe(true);
    opening.values(end, false, true);
    expect(isShot()).toBe(false);
  }
  const { opening } = begun();
  opening.values(view({ flying: false, flier: '' }), true, true); // a window that is too narrow to fly only observes
  expect(isShot()).toBe(true);
});

test('a page whose address is for observing ends the shot', () => {
  const { opening } = begun();
  opening.values(view({ flying: false, flier: '' }), false, false);
  expect(isShot()).toBe(false);
});

test('the words name the key of the first function of the step', () => {
  const { opening } = begun();
  opening.values(view(), false, true);
  expect(small(opening.element).textContent).toContain('hold -Z: up');
  expect(thingToDo([{ use: 'proceed', does: 'proceed' }], null)[0]?.text).toContain('press');
  expect(thingToDo([], [1, 2, 3])).toEqual([]);
  expect(thingToDo([{ use: 'cameraStep +', does: 'next camera' }], null)).toEqual([]);
});

test('the words name the motion that reduces the largest part of the way', () => {
  const uses: readonly UseInfo[] = [
    { use: '-Z', does: 'up' },
    { use: '+X', does: 'forward' },
    { use: '+Z', does: 'down' },
  ];
  const named = (way: Vec3 | null) => thingToDo(uses, way)[1]?.text;
  expect(named([0.2, 0.1, 1.4])).toBe('+Z');
  expect(named([0.2, 0.1, -1.4])).toBe('-Z');
  expect(named([2, 0.1, -1.4])).toBe('+X');
  expect(named([0, -2, 0])).toBe('-Z'); // the step has no such key: the first one
  expect(named(null)).toBe('-Z');
});

import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { NOT_HELD } from '../src/input/hold';
import { KeyRelay, type Relayed } from '../src/input/key-relay';
import { Keyboard } from '../src/input/keyboard';
import { onPress } from '../src/input/press';
import { whenSwallowed } from '../src/input/swallowed';
import { TouchSticks } from '../src/input/touch';

let page: EventTarget & { hidden: boolean };
let around: EventTarget;

beforeEach(() => {
  page = Object.assign(new EventTarget(), { hidden: false });
  around = Object.assign(new EventTarget(), { setInterval: () => 0 });
  vi.stubGlobal('document', page);
  vi.stubGlobal('window', around);
  for (const name of ['HTMLElement', 'HTMLInputElement']) vi.stubGlobal(name, class {});
});

afterEach(() => vi.unstubAllGlobals());

function event(type: string, values: object = {}): Event {
  return Object.assign(new Event(type, { cancelable: true }), values);
}

/** Events after which a browser does not report releases. */
const SWALLOWING: readonly (readonly [string, () => void])[] = [
  ...['blur', 'pagehide', 'beforeprint', 'compositionstart', 'contextmenu', 'dragstart'].map(
    (type) => [type, () => void around.dispatchEvent(event(type))] as const,
  ),
  ...['Meta', 'OS', 'Alt', 'F10'].flatMap((key) =>
    ['keydown', 'keyup'].map(
      (type) => [`${type} ${key}`, () => void around.dispatchEvent(event(type, { key, code: key }))] as const,
    ),
  ),
  [
    'a key with Meta',
    () => void around.dispatchEvent(event('keydown', { key: 'w', code: 'KeyT', metaKey: true })),
  ],
  [
    'a hidden page',
    () => {
      page.hidden = true;
      page.dispatchEvent(event('visibilitychange'));
    },
  ],
];

test.each(SWALLOWING)('%s ends every key, press and touch, in the page and in its windows', (_, swallow) => {
  const ended = new AbortController();
  const told: Relayed[] = [];
  whenSwallowed(() => keyboard.release(), ended.signal);
  const keyboard = new Keyboard({ moved() {}, acted() {}, taken: () => false });
  const lost: number[] = [];
  const element = new EventTarget();
  onPress(element as HTMLElement, () => ({ ended: (each) => lost.push(each) }));
  element.dispatchEvent(event('pointerdown', { pointerId: 1, pointerType: 'mouse' }));
  const relay = new KeyRelay(
    () => true,
    (message) => told.push(message),
  );
  const holds = () => keyboard.held.has('KeyW');
  keyboard.held.add('KeyW');
  swallow();
  expect([holds(), lost, told.filter(({ kind }) => kind === 'released')]).toEqual([
    false,
    [NOT_HELD],
    [{ kind: 'released' }],
  ]);
  swallow();
  expect(lost).toHaveLength(1);
  ended.abort();
  keyboard.held.add('KeyW');
  swallow();
  expect(holds()).toBe(true);
  relay.dispose();
  keyboard.dispose();
});

test('a menu or a drag that the page prevents ends nothing', () => {
  const lost = vi.fn();
  whenSwallowed(lost, new AbortController().signal);
  for (const type of ['contextmenu', 'dragstart']) {
    const prevented = event(type);
    prevented.preventDefault();
    around.dispatchEvent(prevented);
  }
  page.dispatchEvent(event('visibilitychange'));
  expect(lost).not.toHaveBeenCalled();
});

test('the menu of a long press by finger is prevented while a press is followed, that of a mouse is not', () => {
  const lost: string[] = [];
  const element = new EventTarget();
  onPress(element as HTMLElement, () => ({ ended: () => lost.push('press') }));
  element.dispatchEvent(event('pointerdown', { pointerId: 1, pointerType: 'touch' }));
  // Last, because the target of a test has no capture phase.
  whenSwallowed(() => lost.push('keys'), new AbortController().signal);
  const menu = (pointerType: string) => !around.dispatchEvent(event('contextmenu', { pointerType }));
  expect([menu('touch'), lost]).toEqual([true, []]);
  expect([menu('mouse'), lost.sort()]).toEqual([false, ['keys', 'press']]);
  expect(menu('touch')).toBe(false);
});

/** Ways in which the end of a press arrives, if its element receives no release; and whether it counts as lost. */
const ENDS: readonly (readonly [string, object, boolean])[] = [
  ['pointerup', { pointerId: 1, buttons: 0 }, false],
  ['pointercancel', { pointerId: 1 }, true],
  ['lostpointercapture', { pointerId: 1 }, true],
  ['pointermove', { pointerId: 1, buttons: 0 }, true],
  ['pointerdown', { pointerId: 2, pointerType: 'touch', isPrimary: true }, true],
];

test.each(ENDS)('a press ends at %s, wherever it happens', (type, values, lost) => {
  const element = new EventTarget();
  const seen: string[] = [];
  onPress(element as HTMLElement, () => ({
    moved: () => seen.push('moved'),
    ended: (at) => seen.push(`ended ${at === NOT_HELD}`),
  }));
  element.dispatchEvent(event('pointerdown', { pointerId: 1, pointerType: 'touch' }));
  around.dispatchEvent(event('pointerup', { pointerId: 3, buttons: 0 }));
  around.dispatchEvent(event('pointermove', { pointerId: 1, buttons: 1 }));
  around.dispatchEvent(event(type, values));
  around.dispatchEvent(event('pointermove', { pointerId: 1, buttons: 1 }));
  expect(seen).toEqual(['moved', `ended ${lost}`]);
});

test('after all touch sticks were centred, a finger must be lifted before it moves one', () => {
  const sticks = new TouchSticks();
  sticks.show();
  sticks.press(7);
  sticks.put(7, 1, -1);
  expect(sticks.value(1)).toBe(-1);
  sticks.release();
  sticks.put(7, 1, -0.9);
  expect(sticks.value(1)).toBe(0);
  sticks.lift(7, [0, 1]);
  sticks.press(7);
  sticks.put(7, 1, -0.9);
  expect(sticks.value(1)).toBe(-0.9);
  sticks.lift(7, [0, 1]);
  expect(sticks.value(1)).toBe(0);
});

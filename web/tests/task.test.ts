import { expect, test } from 'vitest';
import { isDown, KEYS } from '../src/input/active-device';
import { DEFAULTS } from '../src/input/defaults';
import { Device } from '../src/input/device';
import { USES } from '../src/input/keymap';
import { movers } from '../src/input/rebind';
import protocol from '../src/link/protocol?raw';
import { ending } from '../src/task';
import { countWords } from '../src/task/card';
import { closingWords, goParts, goSentence, goWords, isThere } from '../src/task/to-go';
import { pieces, present, saidText } from '../src/task/words';
import { reading } from './gamepads';
import { condition, FEET, SI, toGo } from './worksite';

const NOTHING = { units: SI, conditions: [] };

test('the functions that a scenario can name are those of the page', () => {
  const names = /export type Use = (.*);/.exec(protocol)?.[1]?.match(/'[^']+'/g) ?? [];
  expect(new Set(names.map((name) => name.slice(1, -1)))).toEqual(new Set(USES.keys()));
});

test('every function has a key, and those of the arm also a button of a pad', () => {
  for (const use of USES.keys()) expect(movers(DEFAULTS.keyboard, use).length, use).toBeGreaterThan(0);
  for (const use of ['+X', '-Z', 'stop', 'rate', 'close', 'open', 'latch', 'cameraStep +'])
    expect(movers(DEFAULTS.pad, use).length, use).toBeGreaterThan(0);
});

test('marks split a text into pieces, and lengths are in the operator’s units', () => {
  expect(pieces('Hold {+X} for {0.0508 m}: *RIGID*.', { ...NOTHING, units: FEET })).toEqual([
    { kind: 'text', text: 'Hold ' },
    { kind: 'use', text: '+X' },
    { kind: 'text', text: ' for ' },
    { kind: 'text', text: '2 in' },
    { kind: 'text', text: ': ' },
    { kind: 'shown', text: 'RIGID' },
    { kind: 'text', text: '.' },
  ]);
  expect(pieces('{1 m}', NOTHING)).toEqual([{ kind: 'text', text: '1 m' }]);
});

test('the mark {wanting} is the first failing condition, the depth last', () => {
  const conditions = [
    condition({ name: 'pin depth', margin: -1, words: 'too far' }),
    condition({ name: 'roll', margin: 1, words: 'rolled' }),
    condition({ name: 'pitch', margin: -1, words: 'pitched' }),
  ];
  const wanting = (shown: typeof conditions) =>
    pieces('{wanting}', { units: SI, conditions: shown })[0]?.text;
  expect(wanting(conditions)).toBe('pitched');
  expect(wanting(conditions.slice(0, 2))).toBe('too far');
  expect(wanting([])).toBe('nothing to capture is near');
});

test('a screen reader says the names of keys, also of marks of punctuation', () => {
  const names: Record<string, string> = { '-Z': 'Q', 'cameraStep +': '.' };
  const inHand = { name: (use: string) => names[use] ?? '', kinds: ['keyboard'] as const };
  const text = pieces('Hold {-Z} for {1 m}, then {cameraStep +}: *RIGID*', NOTHING);
  expect(saidText(text, inHand)).toBe('Hold Q for 1 m, then full stop: RIGID');
});

test('words for keys and for sticks follow the device in use', () => {
  const text = pieces('Release the {key|stick} and the {left hand|left stick}.', NOTHING);
  const said = (kind: 'keyboard' | 'pad' | 'touch') => saidText(text, { name: () => '', kinds: [kind] });
  expect(said('keyboard')).toBe('Release the key and the left hand.');
  for (const kind of ['pad', 'touch'] as const)
    expect(said(kind)).toBe('Release the stick and the left stick.');
});

test('a hint that applies replaces the text and the functions of its step', () => {
  const hint = { text: 'other', uses: [] };
  const step = { title: '', text: 'own', mode: null, uses: [], groups: [], cameras: [], hints: [hint] };
  expect(present(step, { at: 0, hint: -1, first: 0, done_s: [null], debrief: null })).toBe(step);
  expect(present(step, { at: 0, hint: 0, first: 0, done_s: [null], debrief: null })).toBe(hint);
});

test('each component that is left has the stick and key that reduce it', () => {
  const go = toGo({ translation: [1.99, 0.3, -0.254], rotation: [0.005, -0.1, 0] });
  expect(goParts(go, FEET, KEYS, [])).toEqual([
    { axis: 'X', stick: '+X', handle: 'W', value: '6.5 ft', near: false },
    { axis: 'Y', stick: '+Y', handle: 'D', value: '12 in', near: false },
    { axis: 'Z', stick: '−Z', handle: 'Q', value: '10 in', near: false },
    { axis: 'roll', stick: 'roll', handle: '', value: '0.3°', near: true },
    { axis: 'pitch', stick: '−pitch', handle: 'K', value: '5.7°', near: false },
    { axis: 'yaw', stick: 'yaw', handle: '', value: '0.0°', near: true },
  ]);
});

test('three green components are together within the tolerance', () => {
  const [inside, centred, outside] = goParts(toGo({ translation: [0.028, 0.009, -0.03] }), SI, KEYS, []);
  expect([inside?.near, inside?.handle]).toEqual([true, 'W']);
  expect([centred?.near, centred?.handle]).toEqual([true, '']);
  expect([outside?.near, outside?.handle]).toEqual([false, 'Q']);
});

test('speed towards the place is shown while the arm moves, with its direction', () => {
  const words = (closing: number | null) => closingWords(toGo({ closing }), FEET);
  expect([words(0.3048), words(-0.03048), words(0.0001), words(null)]).toEqual([
    '1.00 ft/s',
    '0.10 ft/s away',
    '',
    '',
  ]);
});

test('without a condition, {wanting} depends on what the end effector holds', () => {
  const text = (held: boolean) => pieces('{wanting}', { ...NOTHING, held })[0]?.text;
  expect(text(true)).not.toBe(text(false));
});

test('a joint has one component, without a key', () => {
  const joints = [
    { name: 'elbow_pitch', slides: false },
    { name: 'long_rail', slides: true },
  ];
  const go = toGo({ to: 'elbow pitch', distance: 0, angle: -0.2, shift: [] });
  expect(goParts(go, SI, KEYS, joints)).toEqual([
    { axis: '', stick: '−', handle: '', value: '11.5°', near: false },
  ]);
  expect(goWords(go, SI, joints)).toBe('11.5°');
  const slide = toGo({ to: 'long rail', distance: 0, angle: -0.7, shift: [] });
  expect(goParts(slide, FEET, KEYS, joints)[0]).toMatchObject({ stick: '−', value: '2.3 ft' });
  expect(goSentence(slide, SI, KEYS, joints)).toBe('To long rail: 70 cm.');
});

test('without sticks, only distance and angle are left', () => {
  const go = toGo({ to: 'target', distance: 12.345, angle: 1 });
  expect(goParts(go, SI, KEYS, [])).toEqual([]);
  expect(goSentence(go, SI, KEYS, [])).toBe('To target: 12.35 m, 57.3°.');
  expect(isThere(go)).toBe(false);
  expect(goSentence(toGo({ distance: 0.01, angle: 0.01 }), FEET, KEYS, [])).toBe(
    'To pin: 0.4 in, 0.6°; there.',
  );
});

test('the count names the present step, or at the end those that were done', () => {
  expect(countWords(1, [true, false, false])).toBe('2 of 3');
  expect(countWords(3, [true, true, true])).toBe('All 3 done');
  expect(countWords(3, [true, false, true])).toBe('2 of 3 done, 1 skipped');
});

test('the closing text says "complete", with the time, only without skipped steps', () => {
  expect(ending({ first: 0, done_s: [1, null] })[0]).toBe('Not complete yet');
  expect(ending({ first: 0, done_s: [1, 59.9] }).join()).toMatch(/^Complete.*, 59 s after/);
  expect(ending({ first: 1, done_s: [null, 190, 185] }).join()).toMatch(/, 3 min 10 s after/);
});

test('an axis counts as held if it is past its deadband on the given side', () => {
  const device = new Device('pad', () => {});
  device.read(reading([0, 0, 0, 1]), 0);
  device.read(reading([0.02, -0.5, 0, 1], { 9: 1, 3: 1 }), 20);
  const down = (source: string, sign: 1 | -1 = 1) => isDown(device, source, sign);
  expect([down('a1', -1), down('a1'), down('a0')]).toEqual([true, false, false]);
  expect([down('b3'), down('b9+b3'), down('b9+b0')]).toEqual([true, true, false]);
  expect([down('a3'), down('a3', -1)]).toEqual([false, false]); // its resting place is not known
  device.read(null, 40);
  expect(down('b3')).toBe(false);
});

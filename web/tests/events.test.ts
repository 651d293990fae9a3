import { afterEach, beforeEach, describe, expect, it, test, vi } from 'vitest';
import type { Level, Event as LogEvent } from '../src/link/protocol';
import { EventsGroup } from '../src/panel/desk/events';
import { small, useSmallPage } from './small-page';

beforeEach(useSmallPage);

afterEach(() => {
  vi.unstubAllGlobals();
});

const event = (kind: string, level: Level = 'info'): LogEvent => ({ time_s: 0, kind, level, text: 'A line' });
const kindOf = ({ kind }: LogEvent) => kind;

/** A log that contains no event, but one hint. */
function log() {
  const group = new EventsGroup(['A hint']);
  const element = small(group.element);
  const rows = (list: string) => element.querySelector(list)?.all.filter(({ tag }) => tag === 'li') ?? [];
  const kinds = (list = 'ol.log') => rows(list).map((row) => row.getAttribute('data-kind'));
  const press = (key: string) => element.querySelector(`button.${key}`)?.click();
  return { group, element, rows, kinds, whole: () => kinds('ol.wrapped'), press };
}

describe('a row of the log', () => {
  it('has the kind and the level of its event', () => {
    const { group, rows } = log();
    group.add([event('hands off', 'caution')]);
    const [row, hint] = rows('ol.log');
    expect(row?.getAttribute('data-kind')).toBe('hands off');
    expect(row?.classes).toContain('caution');
    expect(hint?.getAttribute('data-kind')).toBeNull();
  });

  it('has its text in its tooltip too, because it may be cut off', () => {
    const { group, element } = log();
    group.add([event('mode')]);
    const text = element.querySelector('ol.log span');
    expect([text?.textContent, text?.getAttribute('title')]).toEqual(['A line', 'A line']);
  });
});

test('the three newest lines are shown, the newest first', () => {
  const { group, kinds } = log();
  group.add([event('a'), event('b')]);
  expect(kinds()).toEqual(['b', 'a', null]);
  group.add([event('c'), event('d')]);
  expect(kinds()).toEqual(['d', 'c', 'b']);
});

test('every line and the hint are shown in full on demand', () => {
  const { group, whole, press } = log();
  group.add(['a', 'b', 'c', 'd'].map((kind) => event(kind)));
  expect(whole()).toEqual([]);
  press('more');
  expect(whole()).toEqual(['d', 'c', 'b', 'a', null]);
  group.add([event('e')]);
  expect(whole()).toEqual(['e', 'd', 'c', 'b', 'a', null]);
  press('more');
  expect(whole()).toEqual([]);
});

test('only the 200 newest lines are kept', () => {
  const { group, whole, press } = log();
  const lines = Array.from({ length: 250 }, (_, i) => event(`${i}`));
  group.add(lines.slice(0, 120));
  group.add(lines.slice(120));
  press('more');
  expect(whole()).toEqual([...lines.slice(-200).reverse().map(kindOf), null]);
});

test.each<[string, readonly Level[], number]>([
  ['newest warning', ['info', 'warning', 'info'], 1],
  ['newest caution', ['info', 'caution', 'info'], 1],
  ['newest of two cautions', ['caution', 'caution', 'info'], 0],
  ['newest line if there is no caution', ['info', 'info', 'info'], 0],
  ['newest line if only the third line is a caution', ['info', 'info', 'caution'], 0],
])('the wrapped line is the %s', (_, levels, place) => {
  const { group, rows } = log();
  group.add([...levels].reverse().map((level) => event('mode', level)));
  const wrapped = rows('ol.log').map(({ classes }) => classes.includes('whole'));
  expect(wrapped).toEqual([0, 1, 2].map((i) => i === place));
});

describe('a lamp', () => {
  const filtered = () => {
    const made = log();
    made.group.add([event('limit'), event('mode'), event('limit'), event('singular')]);
    made.group.keepTo('SOFT STOP', ['limit']);
    return { ...made, shown: () => made.kinds().filter((kind) => kind !== null) };
  };

  it('filters the log by its kinds', () => {
    expect(filtered().shown()).toEqual(['limit', 'limit']);
  });

  it('shows all lines again after its second press, and after a press of the key “all”', () => {
    const pressed = filtered();
    pressed.group.keepTo('SOFT STOP', ['limit']);
    expect(pressed.shown()).toHaveLength(3);
    const { press, shown } = filtered();
    press('all');
    expect(shown()).toHaveLength(3);
  });

  it('replaces the filter of another lamp', () => {
    const { group, shown } = filtered();
    group.keepTo('SINGULAR', ['singular']);
    expect(shown()).toEqual(['singular']);
  });

  it('without a kind shows all lines', () => {
    const { group, shown } = filtered();
    group.keepTo('RATE LIM', []);
    expect(shown()).toHaveLength(3);
  });

  it('keeps its filter when a line of its kinds is added, and loses it when another line is added', () => {
    const { group, shown } = filtered();
    group.add([event('limit')]);
    expect(shown()).toEqual(['limit', 'limit', 'limit']);
    group.add([event('limit'), event('mode')]);
    expect(shown()).toEqual(['mode', 'limit', 'limit']);
  });

  it('has no filter in a log that was cleared', () => {
    const { group, element, kinds } = filtered();
    const title = () => element.querySelector('h2 .about')?.textContent;
    expect(title()).toContain('SOFT STOP');
    group.clear();
    expect(title()).toBe('');
    expect(kinds()).toEqual([null]);
  });
});

import { beforeEach, expect, test, vi } from 'vitest';
import type { ScenarioInfo } from '../src/link/protocol';
import { DEMO, scenarioRows } from '../src/panel/rail/scenario-rows';
import { thumbnail } from '../src/panel/rail/thumbnails';
import { type SmallElement, small, useSmallPage } from './small-page';

const INFO: ScenarioInfo = {
  ...{ name: 'first-flight', title: 'First flight', text: 'Move the sticks.', group: 'learn', minutes: 2 },
  ...{ given: false, scripted: true },
};
const OWN: ScenarioInfo = {
  ...INFO,
  title: 'Mine',
  group: 'fly',
  minutes: null,
  given: true,
  scripted: false,
};
const TEST: ScenarioInfo = { ...INFO, name: 'flight-test', title: 'Flight test', group: 'study', minutes: 8 };
const nothing = { getItem: () => null, setItem: () => true };

beforeEach(useSmallPage);

function drawn(keeper: Parameters<typeof scenarioRows>[1] = nothing, take = (_: number, __: boolean) => {}) {
  const list = { type: 'scenarios', scenarios: [TEST, OWN, INFO], flown: 0, coming: null } as const;
  return scenarioRows(list, keeper, take).map(small);
}

/** The rows of the list, in the order of the page. */
function rows(groups: readonly SmallElement[]): SmallElement[] {
  return groups.flatMap(({ all }) => all.filter(({ classes }) => classes.includes('choice')));
}

test('the groups come in the order learn, fly, study, each with its own scenarios', () => {
  const titles = drawn().map(({ all }) =>
    all
      .filter(({ tag, parent }) => tag === 'b' && parent?.tag === 'button')
      .map((title) => title.textContent),
  );
  expect(titles).toEqual([['First flight'], ['Mine (your file)'], ['Flight test']]);
});

test('a choice keeps the number that the station gave the scenario', () => {
  const take = vi.fn();
  const [first, own] = rows(drawn(nothing, take));
  first?.querySelector('button')?.click();
  first?.button(DEMO[0])?.click();
  own?.querySelector('button')?.click();
  expect(take.mock.calls).toEqual([
    [2, false],
    [2, true],
    [1, false],
  ]);
});

test('only a scenario with a script offers to fly it', () => {
  expect(rows(drawn()).map((row) => row.button(DEMO[0]) !== undefined)).toEqual([true, false, true]);
});

test('a row tells the minutes if they are known, and the best result of a built-in scenario', () => {
  const kept = {
    getItem: (key: string) => (key.endsWith('.first-flight') ? 'B 65' : null),
    setItem: () => true,
  };
  const [first, own, study] = rows(drawn(kept));
  const said = [first, own, study].map((row) => row?.querySelector('span.minutes')?.textContent);
  expect(said).toEqual(['2 min', '', '8 min']);
  expect(first?.querySelector('i')?.textContent).toContain('B');
  expect(own?.querySelector('i')).toBeNull(); // its name is that of the built-in scenario
  expect(study?.querySelector('i')).toBeNull();
});

test('each built-in scenario has a picture of its own, and a user’s one a neutral picture', () => {
  const [learn, study, own] = [INFO, TEST, OWN].map(({ name, given }) => thumbnail(name, given));
  expect(learn).toMatch(/^data:image\/webp;base64,/);
  expect(study).toMatch(/^data:image\/webp;base64,/);
  expect(own).toMatch(/^data:image\/svg/);
  expect(study).not.toBe(learn);
});

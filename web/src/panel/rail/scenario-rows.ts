/** The rows of the list of scenarios in their groups: picture, title, task, minutes and best result. */

import type { ScenarioGroup, ScenarioInfo, Scenarios } from '../../link/protocol';
import type { Keeper } from '../../page/local-storage';
import { bestOf } from '../../task/best';
import { durationText } from '../../words/format';
import { button, el, setPressed } from '../parts/dom';
import { thumbnail } from './thumbnails';

const GROUPS: Record<ScenarioGroup, readonly [name: string, about: string]> = {
  learn: ['Learn', 'short lessons, one thing at a time'],
  fly: ['Fly', 'missions from the first approach to the last release'],
  study: ['Study', 'motions to look at and to measure'],
};
/** Label of the buttons that let a scenario's script fly, and their tooltip. */
export const DEMO = ['Fly it for me', 'The script flies; move a stick to take over'] as const;

/** `take` is called with the number of the chosen scenario, and with whether its script flies. */
export function scenarioRows(
  { scenarios, flown }: Scenarios,
  keeper: Keeper,
  take: (number: number, demo: boolean) => void,
): HTMLElement[] {
  const rows = scenarios.map((info, number) => ({ info, element: row(info, number) }));

  function row(
    { name: id, title, text, minutes, given, scripted }: ScenarioInfo,
    number: number,
  ): HTMLElement {
    const name = given ? `${title} (your file)` : title;
    const best = given ? null : bestOf(keeper, id);
    const key = button({}, [], () => take(number, false));
    key.append(
      el('img', { src: thumbnail(id, given), alt: '', width: '96', height: '60' }),
      el('b', {}, name),
      el('span', { class: 'minutes' }, minutes === null ? '' : `${minutes} min`),
      el('span', { class: 'text' }, text),
      ...(best ? [el('i', {}, `best ${best.grade}, ${durationText(best.time)}`)] : []),
    );
    setPressed(key, number === flown);
    const [label, about] = DEMO;
    const shows = button({ class: 'demo', title: about, 'aria-label': `${label}: ${name}` }, [label], () =>
      take(number, true),
    );
    return el('div', { class: 'choice' }, key, ...(scripted ? [shows] : []));
  }

  return (Object.keys(GROUPS) as ScenarioGroup[]).map((group) => {
    const [name, about] = GROUPS[group];
    const id = `scenarios-${group}`;
    return el(
      'section',
      { 'aria-labelledby': id },
      el('h2', { id }, el('b', {}, name), ' ', about),
      ...rows.filter(({ info }) => info.group === group).map(({ element }) => element),
    );
  });
}

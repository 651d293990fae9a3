/** The list of scenarios below the scenario's name, and the question before the user leaves a run. */

import type { Frame, Plant, Scenarios } from '../../link/protocol';
import { keeper } from '../../page/local-storage';
import { button, el, setPressed, setText } from '../parts/dom';
import { dropDown } from '../parts/drop-down';
import type { Desk } from '../parts/part';
import { DEMO, scenarioRows } from './scenario-rows';

/** A run counts as flown if a joint has moved by more than this [rad or m]. */
const MOVED = 1e-3;
/** A page that connects later than this after the start of a run cannot know whether the arm has moved [s]. */
const BEGUN_S = 1;

const PLANTS: readonly Plant[] = ['kinematic', 'rigid', 'flexible'];

interface Choice {
  readonly number: number;
  readonly plant: Plant | null;
  /** Whether the scenario's script flies. */
  readonly demo: boolean;
}

export interface ScenarioChoice {
  /** The list, for the rail. */
  readonly element: HTMLElement;
  /** Element over the monitors with the question, or with the name of the scenario that is being prepared. */
  readonly question: HTMLElement;
  /** Button that lets the script fly, in a scenario that has a script but no steps for an operator. */
  readonly script: HTMLElement;
  /** Called for each list of scenarios that the station sends. */
  set(known: Scenarios): void;
  values(frame: Frame): void;
  /** Loads a scenario by its name; asks first if the arm has moved in this run. */
  choose(name: string): void;
  close(): void;
}

/** `chosen` is called with the name of a built-in scenario, which may be the present one. */
export function scenarioChoice({ welcome, send }: Desk, chosen: (name: string) => void): ScenarioChoice {
  let known: Scenarios | null = null;
  let first: Frame | null = null;
  let flown = false;
  let recorded = false;
  /** Whether the task of this run is complete: nothing is lost if the user leaves it. */
  let complete = false;
  let asked: Choice = { number: 0, plant: null, demo: false };
  const list = el('div', { class: 'choices scenarios', role: 'group', 'aria-label': 'Scenarios' });
  const drop = dropDown(welcome.title, `${welcome.title}: ${welcome.text}`, list);
  drop.element.classList.add('scenario');
  const [label, about] = DEMO;
  const script = button({ class: 'fliers', title: about }, [label], () =>
    take(known?.flown ?? -1, null, true),
  );
  script.hidden = true;
  const words = el('p', { role: 'status' });
  const fly = button({}, ['Leave and fly it'], () => {
    send({ type: 'fly_scenario', ...asked });
    question.hidden = true;
  });
  const stay = button({}, ['Stay'], () => {
    question.hidden = true;
  });
  const question = el(
    'section',
    { class: 'leaving', 'aria-label': 'Scenario', hidden: '' },
    words,
    fly,
    stay,
  );
  const take = (number: number, plant: Plant | null = null, demo = false) => {
    const info = known?.scenarios[number];
    drop.open(false);
    if (!info) return;
    if (!info.given && plant === null && !demo) chosen(info.name);
    if (number === known?.flown && (plant === null || plant === welcome.plant) && !demo) return;
    asked = { number, plant, demo };
    if (!flown || complete) {
      send({ type: 'fly_scenario', ...asked });
      return;
    }
    const next = plant === null ? info.title : `${info.title}, ${plant} plant`;
    setText(words, leaving(welcome.title, next, recorded));
    question.hidden = false;
    fly.focus();
  };
  /** Returns the choice of the plant on which the present scenario restarts. */
  const plants = (number: number) =>
    el(
      'div',
      { class: 'plants', role: 'group', 'aria-label': 'Plant' },
      el('span', {}, 'Restart on the plant'),
      ...PLANTS.map((plant) => {
        const choice = button({}, [plant], () => take(number, plant));
        setPressed(choice, plant === welcome.plant);
        return choice;
      }),
    );
  return {
    element: drop.element,
    question,
    script,
    set(now) {
      known = now;
      const rows = scenarioRows(now, keeper, (number, demo) => take(number, null, demo));
      list.replaceChildren(...rows, plants(now.flown));
      const coming = now.coming === null ? undefined : now.scenarios[now.coming];
      question.hidden = !coming;
      for (const key of [fly, stay]) key.hidden = coming !== undefined;
      if (coming) setText(words, `Preparing “${coming.title}”. ${FIRST_TIME}`);
    },
    values(frame) {
      recorded = frame.display.recording_s !== null;
      complete = frame.display.task?.debrief != null;
      const scripted = known?.scenarios[known.flown]?.scripted === true;
      script.hidden = !scripted || welcome.steps.length > 0 || frame.by === 'script';
      if (!first || frame.tick < first.tick) {
        // A run that was in progress before this page connected counts as flown.
        flown = first === null && frame.time_s > BEGUN_S;
        first = frame;
      }
      const { angles } = first;
      flown ||= frame.angles.some((angle, i) => Math.abs(angle - (angles[i] ?? angle)) > MOVED);
    },
    choose(name) {
      take(known?.scenarios.findIndex((info) => info.name === name && !info.given) ?? -1);
    },
    close() {
      drop.open(false);
      if (known?.coming === null) question.hidden = true;
    },
  };
}

const FIRST_TIME =
  'The first preparation on this machine takes about half a minute; meanwhile the arm stops.';

/** Returns the question before the user leaves a run in which the arm has moved. */
export function leaving(left: string, next: string, recorded: boolean): string {
  const kept = recorded ? 'The recording of this run is kept.' : 'This run is not recorded.';
  return `Leave “${left}” for “${next}”? ${kept}`;
}

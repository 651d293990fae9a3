/** The top rail: scenario and phase, mission time, delays, operator, and the keys of the page. */

import type { LinkState } from '../../link/socket';
import type { Appearance } from '../../page/appearance';
import type { Tones } from '../../page/tones';
import { missionTime } from '../../words/format';
import { TASKS } from '../../words/task-phases';
import { button, el, setAttribute, setClass, setPressed, setText } from '../parts/dom';
import type { Desk, View } from '../parts/part';
import { areLong, type Delays, delayWords } from './delays';
import { initialise } from './initialise';
import type { LightControl } from './light';
import type { Naming } from './naming';
import { recordings } from './recordings';
import type { ScenarioChoice } from './scenarios';
import { sound } from './sound';

/** A greater latency from stick to picture is shown as a caution [ms]. */
const SLOW_MS = 100;

export interface RailListener {
  units(): void;
  restart(): void;
  keys(): void;
  controllers(): void;
  console(): void;
}

/** Parts of the page that have a button in the rail. */
export interface RailParts {
  readonly tones: Tones;
  readonly light: LightControl;
  readonly appearance: Appearance;
  readonly scenarios: ScenarioChoice;
  readonly naming: Naming;
  /** Button that opens and closes the guide. */
  readonly guide: HTMLElement;
  /** Button that shows all controls and read-outs. */
  readonly full: HTMLElement;
  /** The observer's button that asks for control. */
  readonly ask: HTMLElement;
  /** Progress of the compilation of the laws. */
  readonly compiling: HTMLElement;
}

/** Measurements of the last 10 s. */
export interface Measured {
  /** Latency from stick to picture, 95th percentile [ms]; null if no stick moved. */
  readonly picture: number | null;
  readonly delays: Delays;
}

export interface Rail {
  readonly element: HTMLElement;
  values(view: View, measured: Measured, who: string, link: LinkState): void;
  /** Shows that the pictures have low detail, and why. */
  simplified(why: string): void;
  /** Closes all open lists. */
  close(): void;
}

export function rail(
  desk: Desk,
  software: boolean,
  { tones, light, ask, appearance, scenarios, naming, guide, full, compiling }: RailParts,
  listener: RailListener,
): Rail {
  const { welcome } = desk;
  // In a scripted run, the script's phases. In a manual run, the report's task phases, which can occur in any order.
  const scripted = welcome.phases.length > 0;
  const steps = scripted ? welcome.phases : welcome.work.cargo.length > 0 ? TASKS : [];
  // There is room for only one name: the name of the present phase.
  const phases = steps.map((name) => ({ name, step: el('li', { title: name, 'aria-label': name }) }));
  const parts = initialise(desk);
  for (const { classList } of [parts.element, light.element]) classList.add('fliers');
  setAttribute(parts.element, 'data-calm', 'full');
  setAttribute(light.element, 'data-calm', 'light');
  const heard = sound(tones);
  const simple = el('span', { class: 'note', title: SOFTWARE, 'data-calm': 'full' }, 'Low detail');
  simple.hidden = !software;
  const lag = el('b');
  const met = el('b');
  const recorded = recordings();
  const units = button({ title: 'Change the units of the read-outs' }, [], () => listener.units());
  const dim = button({ title: DIM, 'data-calm': 'full' }, ['Dim'], () =>
    appearance.set({ night: !appearance.night }),
  );
  const [delayed, takes] = [el('span'), el('b')];
  const delay = el('span', { class: 'delay', title: DELAY }, delayed, takes);
  const element = el(
    'header',
    { class: 'rail' },
    el('h1', {}, 'Aftdeck'),
    scenarios.element,
    el('ol', { class: 'phases', 'aria-label': 'Phases' }, ...phases.map(({ step }) => step)),
    el('span', { class: 'space' }),
    compiling,
    ...(welcome.plant === 'kinematic'
      ? []
      : [el('span', { class: 'note plant', title: PLANTS[welcome.plant] }, `${welcome.plant} arm`)]),
    simple,
    el(
      'span',
      { class: 'times', 'data-calm': 'delays' },
      el('span', { class: 'lag' }, 'Stick to picture ', lag),
      delay,
    ),
    recorded.element,
    el('span', { class: 'met' }, 'MET ', met),
    naming.element,
    ask,
    heard.element,
    el(
      'div',
      { class: 'rail-keys' },
      units,
      button({ class: 'fliers', title: 'Restart the scenario' }, ['Restart'], () => listener.restart()),
      parts.element,
      light.element,
      dim,
      guide,
      full,
      button(
        { title: 'Show the input devices, their keys and axes', 'data-calm': 'controllers' },
        ['Controllers'],
        () => listener.controllers(),
      ),
      button(
        { title: 'Print values of the scenario, and change them in flight', 'data-calm': 'full' },
        ['Console'],
        () => listener.console(),
      ),
      button({ class: 'keys' }, ['Keys ?'], () => listener.keys()),
    ),
  );
  return {
    element,
    values({ frame, flying, controllers, units: shown }, { picture, delays }, controlText, link) {
      light.values(frame, controllers.names);
      scenarios.values(frame);
      const at = scripted ? welcome.phases.indexOf(frame.phase) : frame.work.task - 1;
      phases.forEach(({ name, step }, i) => {
        setClass(step, 'done', scripted && at >= 0 && i < at);
        setClass(step, 'present', i === at);
        setText(step, i === at ? name : '');
      });
      setText(lag, picture === null ? '–' : `${Math.round(picture)} ms`);
      setClass(lag, 'caution', picture !== null && picture > SLOW_MS);
      const { label, text } = delayWords(delays);
      setText(delayed, `${label} `);
      setText(takes, text);
      setClass(delay, 'absent', text === '');
      setClass(element, 'late', areLong(delays));
      setText(met, missionTime(frame.time_s));
      recorded.values(frame);
      heard.values();
      setPressed(dim, appearance.night);
      setText(units, shown.name === 'SI' ? 'SI' : 'ft · in');
      const lost = link.kind !== 'open';
      naming.say(linkWords(link) ?? controlText);
      setClass(naming.key, 'lost', lost);
      setClass(naming.key, 'flying', flying && !lost);
    },
    simplified(why) {
      simple.hidden = false;
      setAttribute(simple, 'title', why);
    },
    close() {
      parts.close();
      light.close();
      scenarios.close();
      recorded.close();
      naming.close();
    },
  };
}

/** Returns the text in place of the operator's name if there is no connection or no session; null otherwise. */
function linkWords(link: LinkState): string | null {
  if (link.kind === 'lost') return `No connection, attempt ${link.attempt}`;
  return link.kind === 'preparing' ? link.text : null;
}

const PLANTS = {
  rigid: 'Servos and brakes turn rigid bodies with masses',
  flexible: 'Servos and brakes turn bodies with masses; gearboxes, booms and base bend',
} as const;
const SOFTWARE =
  'This browser draws without a graphics card; add ?quality=full to the address for full detail.';
const DELAY =
  'CMD: delay from a stick to the arm. TLM: age of figures, lamps and log. CAM: age of pictures. ' +
  'Values of the scenario; in brackets the values of the last 10 s if they differ.';
const DIM = 'Dim for a dark room: the page to 55 %, pictures to 75 % of their brightness';

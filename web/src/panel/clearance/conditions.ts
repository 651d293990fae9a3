/** Conditions of a capture, of docking or of latching; each is in a separate cell, with its limit. */

import type { Names } from '../../input/active-device';
import type { Condition, Work } from '../../link/protocol';
import { conditionText, failureText } from '../../words/condition-text';
import { degrees, fixed, small } from '../../words/format';
import type { Units } from '../../words/units';
import { el, group, setAbout, setAttribute, setClass, setText, svg } from '../parts/dom';
import type { Part } from '../parts/part';
import { ConditionBars } from './condition-bar';
import { Places } from './places';

/** Number of cells. */
const MOST = 6;
/**
 * Abbreviations in the cells, as on the Shuttle's panels. They leave room for the words by which the names of the
 * conditions differ.
 */
const SHORT = { forward: 'fwd', starboard: 'stbd', 'trunnion in guide': 'in guide' } as const;
/** Length of a bar; its limit is in the middle. */
const LENGTH = 100;

export function conditionsGroup(): Part {
  const cells = Array.from({ length: MOST }, cell);
  const element = group(
    'conditions',
    'Conditions',
    el('ol', { class: 'cells' }, ...cells.map((each) => each.element)),
  );
  // Two elements, so that the style sheet can hide the object's name if there is no room for the whole name.
  const [action, object] = [el('span'), el('span')];
  const title = element.querySelector('h2 b');
  title?.replaceChildren(action, object);
  const [places, lengths] = [new Places(MOST), new ConditionBars()];
  let shown: readonly Condition[] = [];
  return {
    element,
    bars({ frame }) {
      const { conditions } = frame.work;
      lengths.learn(conditions);
      shown = places.order(conditions);
      cells.forEach((each, i) => {
        const condition = shown[i];
        if (condition) each.fill(lengths.part(condition));
      });
    },
    values({ frame, units, controllers: { names } }) {
      const { objective, conditions } = frame.work;
      const shownAs = objective ?? { action: 'Conditions', text: 'Conditions' };
      setText(action, shownAs.action);
      setText(object, shownAs.text.slice(shownAs.action.length));
      if (title) setAttribute(title, 'title', shownAs.text);
      cells.forEach((each, i) => {
        each.set(shown[i], units);
      });
      const met = conditions.length > 0 && conditions.every(({ holds }) => holds);
      setClass(element, 'met', met);
      setAbout(element, met ? `all met${whatNow(frame.work, names)}` : failureText(shown, units));
    },
  };
}

/** Returns the next action of the operator when all conditions hold; empty if the mechanism acts automatically. */
export function whatNow({ objective }: Pick<Work, 'objective'>, names: Names): string {
  switch (objective?.action) {
    case 'berth':
      return `: latch, hold ${names.name('latch')}`;
    case 'insert':
      return `: release, hold ${names.name('open')}`;
    case 'capture':
      return `: capture, hold ${names.name('close')}`;
    default:
      return '';
  }
}

function cell() {
  const name = el('span', { class: 'name' });
  const value = el('b');
  const unit = el('span', { class: 'unit' });
  const tick = el('i', { class: 'tick', role: 'img', 'aria-label': 'met' });
  const fill = svg('rect', { class: 'fill', x: '0', y: '3', width: '0', height: '4' });
  const element = el(
    'li',
    {},
    name,
    el('span', { class: 'value' }, value, ' ', unit, tick),
    svg(
      'svg',
      { viewBox: `0 0 ${LENGTH} 10`, preserveAspectRatio: 'none', 'aria-hidden': 'true' },
      svg('rect', { class: 'track', x: '0', y: '3', width: String(LENGTH), height: '4' }),
      fill,
      svg('path', { class: 'limit', d: `M${LENGTH / 2} 0V10` }),
    ),
  );
  return {
    element,
    /** Fills the fraction `part` of the bar; 0.5 is the limit. */
    fill(part: number) {
      setAttribute(fill, 'width', (part * LENGTH).toFixed(1));
    },
    set(condition: Condition | undefined, units: Units) {
      element.hidden = condition === undefined;
      if (!condition) return;
      const shown = figures(condition, units);
      setText(name, shortened(condition.name));
      setText(value, shown.value);
      setText(unit, shown.unit);
      setClass(element, 'holds', condition.holds);
      setAttribute(element, 'title', `${condition.name}: ${conditionText(condition, units)}`);
    },
  };
}

/** A condition's name, abbreviated for its cell. */
export function shortened(name: string): string {
  return Object.entries(SHORT).reduce((text, [long, short]) => text.replace(long, short), name);
}

/** A condition's value in the operator's units. */
export function figures({ value, unit }: Condition, units: Units): { value: string; unit: string } {
  if (!Number.isFinite(value)) return { value: '–', unit: '' };
  switch (unit) {
    case 'm':
      return { value: small(value, units.gap), unit: units.gap.name };
    case 'm/s':
      return { value: small(value, units.creep), unit: units.creep.name };
    case 'rad':
      return { value: degrees(value, 1, false), unit: '°' };
    case 'rad/s':
      return { value: degrees(value, 2, false), unit: '°/s' };
    default:
      return { value: fixed(value, Number.isInteger(value) ? 0 : 1, false), unit };
  }
}

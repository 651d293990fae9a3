/** Fields for the end position and attitude of OPR CMD, and the buttons that fill them and set the target. */

import type { Frame, Vec3 } from '../../link/protocol';
import { attitude, fixed, parseNumber } from '../../words/format';
import type { Units } from '../../words/units';
import { button, el, setClass, setText } from '../parts/dom';
import type { Desk } from '../parts/part';

const NAMES = ['X', 'Y', 'Z', 'Pitch', 'Yaw', 'Roll'] as const;
const DEGREE = Math.PI / 180;

export interface Entry {
  readonly element: HTMLElement;
  /** Whether the fields contain typed or copied values that are not keyed in yet. */
  edited(): boolean;
  /** Whether the fields follow the tip's present pose, because no value was typed, copied or keyed in. */
  follows(): boolean;
  /** Sends the fields as the target; returns false if a field does not contain a number. */
  keyIn(): boolean;
  set(frame: Frame, units: Units): void;
}

/** `label`: name of the pose; `first`: item number of the first field, if the fields have item numbers. */
export function entry(desk: Desk, label = 'Target', first: number | null = null): Entry {
  let edited = false;
  let units: Units | null = null;
  let aimed = '';
  let latest: Frame | null = null;
  let follows = true;

  const heads = NAMES.map(() => el('i'));
  const fields = NAMES.map((name, i) => {
    const field = el('input', {
      type: 'text',
      inputmode: 'decimal',
      autocomplete: 'off',
      spellcheck: 'false',
    });
    field.setAttribute('aria-label', `${label} ${i < 3 ? name : name.toLowerCase()}`);
    field.addEventListener('input', () => {
      edited = true;
      follows = false;
      field.removeAttribute('aria-invalid');
    });
    field.addEventListener('focus', () => field.select());
    field.addEventListener('keydown', (event) => {
      if (event.key === 'Enter' && keyIn()) field.blur();
    });
    return field;
  });
  const cells = NAMES.map((name, i) =>
    el('label', {}, el('span', {}, ...item(i), name, ' ', heads[i] ?? ''), fields[i] ?? ''),
  );
  const element = el(
    'div',
    { class: 'entry' },
    el('div', { class: 'keyed' }, ...[0, 3, 1, 4, 2, 5].map((i) => cells[i] ?? '')),
    el(
      'div',
      { class: 'switch' },
      button({ title: 'Copy the present point into the fields' }, ['Present'], copyPresent),
      button({ title: 'Set the fields as the target' }, ['Key in'], () => keyIn()),
    ),
  );

  function item(i: number): readonly HTMLElement[] {
    return first === null ? [] : [el('i', { class: 'item' }, String(first + i))];
  }

  function write(position: Vec3, angles: Vec3, shown: Units): void {
    const lengths = position.map((value) => fixed(value * shown.length.perSi, shown.length.decimals));
    fill([...lengths, ...angles.map(attitude)]);
  }

  function fill(texts: readonly string[]): void {
    fields.forEach((field, i) => {
      const text = texts[i] ?? '';
      if (field.value !== text) field.value = text;
      field.removeAttribute('aria-invalid');
    });
  }

  /**
   * Shows the tip's pose in the fields or, if the point of resolution is the payload's, clears the fields. Does nothing
   * while a field has the focus.
   */
  function follow(frame: Frame, shown: Units): void {
    if (element.contains(document.activeElement)) return;
    if (showsTip(frame)) write(frame.display.actual.position, frame.display.actual.attitude, shown);
    else fill([]);
  }

  /** Returns whether the point of resolution is the tip. OPR CMD moves the tip. */
  function showsTip({ mode }: Frame): boolean {
    return desk.welcome.modes.find(({ position }) => position === mode)?.point !== 'payload';
  }

  /** Converts the typed lengths to the units that are displayed now. */
  function convert(from: Units, to: Units): void {
    for (const field of fields.slice(0, 3)) {
      const value = parseNumber(field.value);
      if (value === null) continue;
      field.value = fixed((value / from.length.perSi) * to.length.perSi, to.length.decimals);
    }
  }

  function copyPresent(): void {
    if (!latest || !units) return;
    if (!showsTip(latest)) {
      desk.say(
        '“Present” is rejected: the displayed point is the payload’s, but OPR CMD moves the tip; enter ORB UNL first.',
      );
      return;
    }
    write(latest.display.actual.position, latest.display.actual.attitude, units);
    edited = true;
    follows = false;
  }

  function keyIn(): boolean {
    if (!units) return false;
    const numbers = fields.map(({ value }) => parseNumber(value));
    const wrong = numbers.indexOf(null);
    if (wrong >= 0) {
      fields[wrong]?.setAttribute('aria-invalid', 'true');
      const typed = fields[wrong]?.value.trim();
      desk.say(`Target ${NAMES[wrong]}: ${typed ? `“${typed}” is not a number` : 'the field is empty'}.`);
      return false;
    }
    const [x = 0, y = 0, z = 0, pitch = 0, yaw = 0, roll = 0] = numbers.map((value) => value ?? 0);
    const metre = 1 / units.length.perSi;
    desk.send({
      type: 'set_target',
      position: [x * metre, y * metre, z * metre],
      attitude: [pitch * DEGREE, yaw * DEGREE, roll * DEGREE],
    });
    edited = false;
    return true;
  }

  return {
    element,
    edited: () => edited,
    follows: () => follows,
    keyIn,
    set(frame, shown) {
      latest = frame;
      if (units && units !== shown) convert(units, shown);
      // The typed values stay until the station has another target, so that rejected values can be corrected.
      const { aim } = frame.display;
      const key = aim ? JSON.stringify([aim.position, aim.attitude]) : '';
      if (!aim && aimed && !edited) follows = true; // the run was restarted
      if (aim && !edited && (follows || key !== aimed)) {
        write(aim.position, aim.attitude, shown);
        follows = false;
      } else if (follows) follow(frame, shown);
      aimed = key;
      units = shown;
      heads.forEach((head, i) => {
        setText(head, i < 3 ? shown.length.name : '°');
      });
      setClass(element, 'edited', edited);
    },
  };
}

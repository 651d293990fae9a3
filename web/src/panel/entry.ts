/** Fields for the end position and attitude of OPR CMD, and the keys that fill and take them. */

import { attitude, fixed, parseNumber } from '../format';
import type { Frame, Vec3 } from '../protocol';
import type { Units } from '../units';
import { button, el, setClass, setText } from './dom';
import type { Desk } from './part';

const NAMES = ['X', 'Y', 'Z', 'Pitch', 'Yaw', 'Roll'] as const;
const DEGREE = Math.PI / 180;

export interface Entry {
  readonly element: HTMLElement;
  /** Something was typed that is not keyed in yet. */
  edited(): boolean;
  /** Sends the fields as the target; false where one holds no number. */
  keyIn(): boolean;
  set(frame: Frame, units: Units): void;
}

/** `label`: what people call the pose; `first`: number of the first field's item, where the fields have numbers. */
export function entry(desk: Desk, label = 'Target', first: number | null = null): Entry {
  let edited = false;
  let units: Units | null = null;
  let aimed = '';
  let latest: Frame | null = null;
  let filled = false;

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
      button({ title: 'Writes the present point into the fields' }, ['Present'], copyPresent),
      button({ title: 'Takes the fields as the target' }, ['Key in'], () => keyIn()),
    ),
  );

  function item(i: number): readonly HTMLElement[] {
    return first === null ? [] : [el('i', { class: 'item' }, String(first + i))];
  }

  function write(position: Vec3, angles: Vec3, shown: Units): void {
    position.forEach((value, i) => {
      const field = fields[i];
      if (field) field.value = fixed(value * shown.length.perSi, shown.length.decimals);
    });
    angles.forEach((value, i) => {
      const field = fields[3 + i];
      if (field) field.value = attitude(value);
    });
    for (const field of fields) field.removeAttribute('aria-invalid');
  }

  /** Whether the point of resolution is the tip, which OPR CMD moves. */
  function showsTip({ mode }: Frame): boolean {
    return desk.welcome.modes.find(({ position }) => position === mode)?.point !== 'payload';
  }

  /** The lengths typed, in the units now shown. */
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
      desk.say('Present: the point shown is the payload’s, and OPR CMD moves the tip; enter ORB UNL first.');
      return;
    }
    write(latest.actual.position, latest.actual.attitude, units);
    edited = true;
  }

  function keyIn(): boolean {
    if (!units) return false;
    const numbers = fields.map(({ value }) => parseNumber(value));
    const wrong = numbers.indexOf(null);
    if (wrong >= 0) {
      fields[wrong]?.setAttribute('aria-invalid', 'true');
      const typed = fields[wrong]?.value.trim();
      desk.say(`Target ${NAMES[wrong]}: ${typed ? `“${typed}” is not a number` : 'nothing is keyed in'}.`);
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
    keyIn,
    set(frame, shown) {
      latest = frame;
      if (units && units !== shown) convert(units, shown);
      // What was typed stays until the station has another target; a refused one is there to be mended.
      const { aim } = frame;
      const key = aim ? JSON.stringify([aim.position, aim.attitude]) : '';
      if (aim && key !== aimed && !edited) write(aim.position, aim.attitude, shown);
      else if (!filled && !edited && showsTip(frame)) {
        write(frame.actual.position, frame.actual.attitude, shown);
        filled = true;
      }
      aimed = key;
      units = shown;
      heads.forEach((head, i) => {
        setText(head, i < 3 ? shown.length.name : '°');
      });
      setClass(element, 'edited', edited);
    },
  };
}

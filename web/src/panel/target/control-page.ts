/**
 * The page PDRS CONTROL over the monitors, modelled on the Shuttle's display SPEC 94: the target, the stored points,
 * the switches of POSITION HOLD and of ORB LD, and the payload table. Items have the numbers of SPEC 94. Items
 * without a function in this simulator are omitted.
 */

import { keyOf } from '../../input/layout';
import type { Frame } from '../../link/protocol';
import { verdict } from '../desk/verdict';
import { button, el, setAttribute, setPressed, setText } from '../parts/dom';
import type { Desk, View } from '../parts/part';
import { entry } from './entry';
import { payloadTable } from './payload-table';
import { storedPoints } from './stored-points';
import { remaining } from './target';

/** Items 18 to 23: the fields of the end position and attitude. */
const FIRST_FIELD = 18;
const HANDS = { prong: 'fixed finger and prong', snares: 'snares' } as const;

export class ControlPage {
  readonly element = el('dialog', {
    class: 'control-page',
    'aria-label': 'PDRS control',
    tabindex: '-1',
    autofocus: '',
  });
  private readonly held = el('dd');
  private readonly point = el('dd');
  private readonly hold: readonly [HTMLButtonElement, HTMLButtonElement];
  private readonly axes: readonly [HTMLButtonElement, HTMLButtonElement];
  private readonly keyed;
  private readonly check = verdict();
  private readonly checked = el(
    'div',
    { class: 'verdict' },
    el('i', { class: 'item' }, '25'),
    this.check.element,
  );
  private readonly togo = el('p', { class: 'remaining' });
  private readonly points;
  private readonly payloads;
  private readonly done;

  constructor(private readonly desk: Desk) {
    const { welcome } = desk;
    const holds = (item: number, name: string, on: boolean) =>
      switched(item, name, () => desk.send({ type: 'position_hold', on }));
    this.hold = [holds(28, 'Ena', true), holds(29, 'Inh', false)];
    this.axes = [
      switched(
        31,
        'Norm',
        () => desk.send({ type: 'payload_axes', on: false }),
        'Rotate in orbiter axes, mode 4',
      ),
      switched(
        null,
        'Payload',
        () => desk.send({ type: 'payload_axes', on: true }),
        'Rotate in payload axes, mode 7',
      ),
    ];
    this.keyed = entry(desk, 'End', FIRST_FIELD);
    this.points = storedPoints(welcome.sequences);
    this.payloads = payloadTable(welcome);
    this.done = button({ class: 'done' }, ['Close'], () => this.close());
    const rows: readonly (readonly [string, string, HTMLElement])[] = [
      ['3', 'PL ID', this.held],
      ['4', 'End eff', el('dd', {}, HANDS[welcome.work.hand])],
      ['30', 'POR display', this.point],
    ];
    this.element.append(
      el(
        'header',
        { role: 'presentation' },
        el('h2', {}, 'PDRS control ', el('small', {}, 'as SPEC 94')),
        this.done,
      ),
      el(
        'div',
        { class: 'set' },
        el('h3', {}, 'As set'),
        el(
          'dl',
          {},
          ...rows.flatMap(([item, name, value]) => [
            el('dt', {}, el('i', { class: 'item' }, item), name),
            value,
          ]),
        ),
        labelled('POHS', 'Position hold', this.hold),
        labelled('ORB LD ref', 'Command reference of ORB LD', this.axes),
      ),
      el(
        'div',
        { class: 'end' },
        el('h3', {}, 'End position, end attitude'),
        this.keyed.element,
        this.checked,
        this.togo,
      ),
      this.points.element,
      this.payloads.element,
    );
  }

  toggle(): void {
    if (this.element.open) this.close();
    else {
      this.element.show();
      this.element.focus();
    }
  }

  close(): void {
    this.element.close();
  }

  values({ frame, units }: View): void {
    if (!this.element.open) return;
    const { welcome } = this.desk;
    const held = welcome.payloads.find(({ id }) => id === frame.display.payload_id);
    setText(this.held, held ? `${held.id}  ${held.name}` : '–');
    setText(this.point, this.pointOf(frame));
    this.hold.forEach((key, i) => {
      setPressed(key, frame.position_hold === (i === 0));
    });
    this.axes.forEach((key, i) => {
      setPressed(key, frame.payload_axes === (i === 1));
    });
    this.keyed.set(frame, units);
    this.check.set(frame);
    this.checked.hidden = this.check.element.hidden;
    const none = this.keyed.follows()
      ? 'No target keyed in: this is the present point.'
      : remaining(frame, units);
    setText(this.togo, this.keyed.edited() ? 'Not keyed in yet.' : none);
    this.points.set(frame, units);
    this.payloads.set(frame, units);
    setAttribute(this.done, 'title', `${keyOf('control page')} or Esc`);
  }

  /** Returns the name of the point of resolution of the present mode. */
  private pointOf({ mode }: Frame): string {
    const point = this.desk.welcome.modes.find(({ position }) => position === mode)?.point;
    return point === 'payload' ? 'payload' : 'tip';
  }
}

function switched(item: number | null, name: string, pressed: () => void, title = ''): HTMLButtonElement {
  const number = item === null ? [] : [el('i', { class: 'item' }, String(item))];
  return button(title ? { title } : {}, [...number, name], pressed);
}

function labelled(name: string, title: string, keys: readonly HTMLElement[]): HTMLElement {
  return el(
    'div',
    { class: 'setting' },
    el('span', { title }, name),
    el('div', { class: 'switch plain', role: 'group', 'aria-label': title }, ...keys),
  );
}

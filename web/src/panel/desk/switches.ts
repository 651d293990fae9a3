/** The switches under the MODE rotary. Only the switches of the selected mode are visible. */

import type { Frame, LawChoice, ModeInfo } from '../../link/protocol';
import { button, el, setAttribute, setClass, setPressed, setText } from '../parts/dom';
import type { Desk } from '../parts/part';

/** The keys that select the steering law: value, label, and number of the law in the report. */
const LAWS: readonly (readonly [LawChoice, string, number])[] = [
  ['position', 'Position', 1],
  ['closed loop', 'Closed', 2],
  ['open loop', 'Open', 3],
];

export interface Switches {
  readonly element: HTMLElement;
  /** `mode`: the selected mode, or the entered mode if none is selected. */
  set(frame: Frame, mode: ModeInfo | undefined): void;
  /** Turns the JOINT rotary by one joint. */
  turnJoint(by: number): void;
}

export function switches(desk: Desk): Switches {
  const count = desk.welcome.joints.length;
  let joint = 0;
  let inPayloadAxes = false;

  const laws = LAWS.map(([law, name, number]) =>
    button({ title: `${law}, mode ${number}`, 'aria-label': law }, [name], () =>
      desk.send({ type: 'select_law', law }),
    ),
  );
  const law = el(
    'div',
    { class: 'switch plain', role: 'group', 'aria-label': 'Law', 'data-calm': 'full' },
    ...laws,
  );
  const axes = button(
    { class: 'axes', title: 'Rotate in payload axes (mode 7) or in orbiter axes (mode 4)' },
    ['Rotate in payload axes'],
    () => desk.send({ type: 'payload_axes', on: !inPayloadAxes }),
  );
  const words = el('p', { class: 'words' });
  const ready = el('small', {}, 'Ready');
  const running = el('small', {}, 'In prog');
  const sequence = el(
    'div',
    { class: 'switch sequence', 'data-calm': 'proceed' },
    button({ class: 'proceed' }, ['Proceed', ready], () => desk.act('proceed')),
    button({ class: 'stop' }, ['Stop', running], () => desk.send({ type: 'stop' })),
  );
  const joints = desk.welcome.joints.map(({ label }, index) =>
    button({}, [label], () => desk.send({ type: 'select_joint', joint: index })),
  );
  const jointRotary = el('div', { class: 'joint-rotary', role: 'group', 'aria-label': 'Joint' }, ...joints);

  return {
    element: el('div', { class: 'switches' }, law, axes, words, sequence, jointRotary),
    set(frame, mode) {
      joint = frame.joint;
      inPayloadAxes = frame.payload_axes;
      // STOP stays visible while an automatic motion is in progress.
      const single = mode?.kind === 'single' && frame.sequence !== 'in progress';
      const automatic = mode?.kind === 'automatic';
      const loaded = mode?.kind === 'manual' && mode.laws.length > 1;
      law.hidden = !automatic;
      axes.hidden = !loaded;
      words.hidden = single || automatic || loaded;
      sequence.hidden = single;
      jointRotary.hidden = !single;
      setText(words, mode?.title ?? '');
      setAttribute(words, 'title', mode?.title ?? '');
      setPressed(axes, frame.payload_axes);
      laws.forEach((key, i) => {
        setPressed(key, LAWS[i]?.[0] === frame.law_choice);
      });
      joints.forEach((key, i) => {
        setPressed(key, i === joint);
      });
      const test = frame.mode === 'TEST';
      setClass(ready, 'lit', test || frame.sequence === 'ready');
      setClass(running, 'lit', test || frame.sequence === 'in progress');
    },
    turnJoint(by) {
      desk.send({ type: 'select_joint', joint: (joint + by + count) % count });
    },
  };
}

/** Angles and lengths of the joints between their limits, and joint rates as fractions of their limits. */

import { type Limit, READOUTS } from '../../link/protocol';
import { EXAGGERATION } from '../../scene/bending';
import { coordinateText, coordinateUnit, rangeText } from '../../words/joint';
import { motionWords, TELESCOPE } from '../../words/motion-words';
import { loadBar, rateBar } from '../parts/bar';
import { button, el, group, setAbout, setAttribute, setClass, setPressed, setText, svg } from '../parts/dom';
import type { Desk, Part } from '../parts/part';
import { jointBar } from './joint-bar';
import { jointHead } from './joint-head';
import { place } from './joint-scale';
import { standRow } from './stand';

export interface JointsGroup extends Part {
  /** Marks the button of exaggerated bending; `on`: whether the pictures exaggerate it. */
  setBending(on: boolean): void;
}

export function joints(desk: Desk): JointsGroup {
  const rows = desk.welcome.joints.map((joint) => {
    // A hollow mark above the bar. It hides the pointer's stem if both have the same position.
    const commanded = svg('path', { class: 'commanded', d: 'M-3.8 0 H3.8 L0 6.4 Z' });
    const scale = jointBar(joint, commanded);
    const angle = el('td', { class: 'angle' });
    const head = jointHead(joint);
    const track = el('td', { class: 'scale' }, scale.element);
    const tag = el('span', { class: 'limit-tag' });
    const bar = rateBar();
    const torque = joint.torque === null ? null : loadBar();
    const row = el(
      'tr',
      {},
      head.element,
      track,
      angle,
      el('td', { class: 'of-limit' }, el('div', {}, bar.element, tag)),
      ...(torque ? [el('td', { class: 'torque' }, el('div', {}, torque.element))] : []),
    );
    return { joint, head, row, track, scale, commanded, angle, bar, torque, tag };
  });
  const stand = desk.welcome.work.stand && standRow(desk.welcome.work.stand);
  const loaded = desk.welcome.plant !== 'kinematic';
  const element = group(
    'joints',
    'Joints',
    el(
      'table',
      {},
      el(
        'thead',
        {},
        el(
          'tr',
          {},
          el('td'),
          el(
            'th',
            { class: 'legend', scope: 'col' },
            el('i', { class: 'reach' }),
            'reach ',
            el('i', { class: 'soft' }),
            'soft ',
            ...(loaded ? [] : [el('i', { class: 'hard' }), 'hard']), // no room beside the torques
          ),
          el('th', { scope: 'col' }, desk.welcome.joints.every(({ slides }) => slides) ? '' : 'deg'),
          el('th', { scope: 'col' }, 'of limit'),
          ...(loaded ? [el('th', { scope: 'col', title: READOUTS.torque_of_limit.about }, 'torque')] : []),
        ),
      ),
      el('tbody', {}, ...rows.map(({ row }) => row), ...(stand ? [stand.element] : [])),
    ),
  );
  setClass(element, 'loaded', loaded);
  const bendKey = button({ class: 'more', title: BENDING }, [`Bend × ${EXAGGERATION}`], () =>
    desk.act('bending'),
  );
  if (desk.welcome.flexures.length > 0) element.querySelector('h2')?.append(bendKey);
  return {
    element,
    setBending(on) {
      setPressed(bendKey, on);
    },
    bars({ frame }) {
      stand?.point(frame.work.stand ?? 0);
      rows.forEach(({ joint, scale, commanded, bar, torque }, i) => {
        torque?.set((frame.dynamics?.torques[i] ?? 0) / ((frame.brakes ? joint.holding : joint.torque) ?? 1));
        scale.set(frame.angles[i] ?? 0);
        const at = place(joint, frame.angles_commanded[i] ?? 0).toFixed(2);
        setAttribute(commanded, 'transform', `translate(${at} 0)`);
        const limit = frame.rate_limits[i] || 1;
        bar.set((frame.rates[i] ?? 0) / limit, (frame.rates_commanded[i] ?? 0) / limit);
      });
    },
    values({ frame, units, controllers }) {
      stand?.set(frame.work.stand ?? 0, units, controllers.names);
      const mode = desk.welcome.modes.find((each) => each.position === frame.mode);
      const single = mode?.kind === 'single';
      setClass(element, 'single', single);
      const telescope = motionWords(frame.motions.filter(({ text }) => text.startsWith(TELESCOPE)));
      setAbout(element, single ? `${desk.welcome.joints[frame.joint]?.label ?? ''} selected` : telescope);
      rows.forEach(({ joint, head, row, track, angle, tag }, i) => {
        const zone = frame.zones[i] ?? 0;
        head.set(coordinateUnit(joint, units).name);
        setAttribute(track, 'title', rangeText(joint, units));
        setText(angle, coordinateText(joint, frame.angles[i] ?? 0, units));
        setClass(row, 'selected', single && frame.joint === i);
        setClass(row, 'reach', zone >= 1);
        setClass(row, 'soft', zone >= 2);
        const acting = frame.limits.find((limit) => limit.joint === i);
        setText(tag, acting ? SHORT[acting.kind] : '');
        setClass(row, 'limited', acting !== undefined);
        setClass(row, 'overdriven', frame.dynamics?.overdriven.includes(i) ?? false);
      });
    },
  };
}

const BENDING = 'Draw the bending of the arm larger than it is';

const SHORT: Readonly<Record<Limit['kind'], string>> = {
  'joint rate': 'rate',
  'joint acceleration': 'acc',
  'soft stop': 'soft',
  'hard stop': 'hard',
  singularity: 'sing',
  'POR translation': '',
  'POR rotation': '',
  'POR acceleration': '',
  seat: '',
  contact: '',
  switch: '',
};

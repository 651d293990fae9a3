/** The master arm: sliders in place of the joints. The sticks move them, too. In MASTER the arm follows them. */

import type { Frame } from '../../link/protocol';
import { coordinateText, coordinateUnit } from '../../words/joint';
import { el, group, setAbout, setText } from '../parts/dom';
import { Paced } from '../parts/paced';
import type { Desk, Part } from '../parts/part';
import { jointHead } from './joint-head';
import { slider } from './slider';
import { standRow } from './stand';

/** Least time between two messages [ms]. */
const PERIOD_MS = 50;
/** For this time after the last change on this page, the page's own coordinates are displayed, not the station's [ms]. */
const OWN_MS = 500;

export interface MasterGroup extends Part {
  /** Sets the master to the arm's present coordinates, so that the arm stops. */
  meet(): void;
}

export function masterGroup(desk: Desk): MasterGroup {
  let own: { readonly angles: readonly number[]; readonly at: number } | null = null;
  let latest: Frame | null = null;
  const out = new Paced<readonly number[]>(PERIOD_MS, (angles) => desk.send({ type: 'master', angles }));

  const put = (angles: readonly number[]) => {
    own = { angles, at: performance.now() };
    out.put(angles);
  };
  /**
   * Returns the master's coordinates. For `OWN_MS` after a change on this page, these are the page's own; otherwise the
   * station's in MASTER, and the arm's in other modes.
   */
  const master = (frame: Frame): readonly number[] => {
    if (own && performance.now() - own.at > OWN_MS) own = null;
    return own?.angles ?? frame.work.master ?? frame.angles;
  };
  const rows = desk.welcome.joints.map((joint, i) => {
    const bar = slider(joint, (coordinate) => {
      if (latest) put(master(latest).with(i, coordinate));
    });
    const actual = el('td', { class: 'angle' });
    const commanded = el('td', { class: 'commanded' });
    const title = joint.stick ? { title: `${joint.stick} also moves this joint` } : {};
    const head = jointHead(joint, 'row', title);
    const row = el('tr', {}, head.element, el('td', { class: 'scale' }, bar.element), actual, commanded);
    return { joint, head, bar, actual, commanded, row };
  });
  const stand = desk.welcome.work.stand && standRow(desk.welcome.work.stand);
  const heads = ['', '', 'actual', 'master'].map((name) => el('th', { scope: 'col' }, name));
  const element = group(
    'master-arm',
    'Master arm',
    el(
      'table',
      {},
      el('thead', {}, el('tr', {}, ...heads)),
      el('tbody', {}, ...rows.map(({ row }) => row), ...(stand ? [stand.element] : [])),
    ),
  );
  const thc = desk.welcome.joints.flatMap(({ stick }) => (stick?.startsWith('THC') ? [stick.slice(4)] : []));
  const unit = desk.welcome.joints.every(({ slides }) => slides) ? '' : 'degrees; ';
  setAbout(element, `${unit}sliders, or THC ${thc.join(' ')} and RHC`);
  return {
    element,
    meet() {
      if (latest) put(latest.angles);
    },
    bars({ frame, units }) {
      latest = frame;
      stand?.point(frame.work.stand ?? 0);
      const goal = master(frame);
      rows.forEach(({ bar }, i) => {
        bar.set(frame.angles[i] ?? 0, goal[i] ?? 0, units);
      });
    },
    values({ frame, units, controllers }) {
      stand?.set(frame.work.stand ?? 0, units, controllers.names);
      const goal = master(frame);
      rows.forEach(({ joint, head, actual, commanded }, i) => {
        head.set(coordinateUnit(joint, units).name);
        setText(actual, coordinateText(joint, frame.angles[i] ?? 0, units));
        setText(commanded, coordinateText(joint, goal[i] ?? 0, units));
      });
    },
  };
}

/** Joint angles between their limits, and joint rates as parts of theirs. */

import { degrees } from '../format';
import type { JointInfo, Limit } from '../protocol';
import { rateBar } from './bar';
import { el, group, setAbout, setAttribute, setClass, setText, svg } from './dom';
import { BAR, place } from './joint-scale';
import type { Desk, Part } from './part';

export function joints(desk: Desk): Part {
  const rows = desk.welcome.joints.map((joint) => {
    const pointer = svg('path', { class: 'pointer', d: 'M0 11 L4.5 20 H-4.5 Z M-0.9 0 H0.9 V12 H-0.9 Z' });
    const zero = place(joint, 0).toFixed(1);
    const scale = svg(
      'svg',
      {
        class: 'joint-bar',
        viewBox: `-3 0 ${BAR + 6} 20`,
        preserveAspectRatio: 'none',
        'aria-hidden': 'true',
      },
      svg('rect', { class: 'track', x: '0', y: '7', width: String(BAR), height: '5' }),
      ...zones(),
      svg('path', { class: 'tick', d: `M${zero} 5 V14` }),
      pointer,
    );
    const angle = el('td', { class: 'angle' });
    const name = el('th', { scope: 'row' }, joint.label);
    const tag = el('span', { class: 'limit-tag' });
    const bar = rateBar();
    const row = el(
      'tr',
      {},
      name,
      el('td', { class: 'scale', title: range(joint) }, scale),
      angle,
      el('td', { class: 'of-limit' }, el('div', {}, bar.element, tag)),
    );
    return { row, pointer, angle, bar, tag, joint };
  });
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
          el('th'),
          el(
            'th',
            { class: 'legend', scope: 'col' },
            el('i', { class: 'reach' }),
            'reach ',
            el('i', { class: 'soft' }),
            'soft ',
            el('i', { class: 'hard' }),
            'hard',
          ),
          el('th', { scope: 'col' }, 'deg'),
          el('th', { scope: 'col' }, 'of limit'),
        ),
      ),
      el('tbody', {}, ...rows.map(({ row }) => row)),
    ),
  );
  return {
    element,
    bars({ frame }) {
      rows.forEach(({ pointer, bar, joint }, i) => {
        setAttribute(pointer, 'transform', `translate(${place(joint, frame.joints[i] ?? 0).toFixed(2)} 0)`);
        const limit = frame.rate_limits[i] || 1;
        bar.set((frame.rates[i] ?? 0) / limit, (frame.rates_commanded[i] ?? 0) / limit);
      });
    },
    values({ frame }) {
      const mode = desk.welcome.modes.find((each) => each.position === frame.mode);
      const single = mode?.kind === 'single';
      setClass(element, 'single', single);
      setAbout(element, single ? `${desk.welcome.joints[frame.joint]?.label ?? ''} selected` : '');
      rows.forEach(({ row, angle, tag }, i) => {
        const zone = frame.zones[i] ?? 0;
        setText(angle, degrees(frame.joints[i] ?? 0));
        setClass(row, 'selected', single && frame.joint === i);
        setClass(row, 'reach', zone >= 1);
        setClass(row, 'soft', zone >= 2);
        const acting = frame.limits.find((limit) => limit.joint === i);
        setText(tag, acting ? SHORT[acting.kind] : '');
        setClass(row, 'limited', acting !== undefined);
      });
    },
  };
}

const SHORT: Readonly<Record<Limit['kind'], string>> = {
  'joint rate': 'rate',
  'soft stop': 'soft',
  'hard stop': 'hard',
  singularity: 'sing',
  'POR translation': '',
  'POR rotation': '',
  'POR acceleration': '',
};

function zones(): SVGElement[] {
  const rect = (name: string, x: number) =>
    svg('rect', { class: name, x: String(x), y: '6', width: '9', height: '7' });
  const hatch = (x: number) =>
    svg('path', { class: 'hatch', d: `M${x + 1} 13 l3.5 -7 M${x + 4.5} 13 l3.5 -7` });
  const post = (x: number) =>
    svg('rect', { class: 'post', x: String(x - 1), y: '3', width: '2', height: '13' });
  return [
    ...[0, BAR - 9].flatMap((x) => [rect('soft', x), hatch(x)]),
    ...[9, BAR - 18].map((x) => rect('reach', x)),
    post(0),
    post(BAR),
  ];
}

function range({ label, reach, soft, hard }: JointInfo): string {
  const pair = ([low, high]: readonly [number, number]) => `${degrees(low)}° to ${degrees(high)}°`;
  return `${label}: reach ${pair(reach)}, soft ${pair(soft)}, hard ${pair(hard)}`;
}

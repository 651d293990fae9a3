/**
 * A row for each singularity, with the distance from it, 0 to 1. If the distance is below the arm's threshold, the row
 * is marked as a caution and names the escape direction.
 */

import { capitalised, fixed } from '../../words/format';
import { spoken, wayOutText } from '../../words/way-out';
import { el, group, setAbout, setAttribute, setClass, setText, svg } from '../parts/dom';
import type { Desk, Part } from '../parts/part';

const LENGTH = 200;

export function singularity({ welcome: { singularities, singular, joints } }: Desk): Part {
  const rows = singularities.map((name) => {
    const pointer = svg('rect', { class: 'pointer', y: '3', x: '-3', width: '6', height: '12' });
    const label = el('span', { class: 'label' }, capitalised(name));
    const value = el('span', { class: 'value' });
    const bar = svg(
      'svg',
      { viewBox: `-4 0 ${LENGTH + 8} 18`, preserveAspectRatio: 'none', 'aria-hidden': 'true' },
      svg('rect', { class: 'track', x: '0', y: '7', width: String(LENGTH), height: '4' }),
      svg('rect', { class: 'reach', x: '0', y: '7', width: String(singular * LENGTH), height: '4' }),
      pointer,
    );
    return {
      name,
      title: capitalised(name),
      pointer,
      label,
      value,
      row: el('div', { class: 'distance' }, label, bar, value),
    };
  });
  const gauges = el('div', { class: 'gauges' }, ...rows.map(({ row }) => row));
  const element = group('singularity', 'Singularity', gauges);
  setAbout(element, `caution below ${fixed(singular, 2, false)}`);
  return {
    element,
    bars({ frame }) {
      rows.forEach(({ pointer }, i) => {
        const at = Math.min(1, Math.abs(frame.singularity[i] ?? 0)) * LENGTH;
        setAttribute(pointer, 'transform', `translate(${at.toFixed(1)} 0)`);
      });
    },
    values({ frame, controllers: { names } }) {
      rows.forEach(({ name, title, label, value, row }, i) => {
        const distance = Math.abs(frame.singularity[i] ?? 0);
        const near = distance < singular;
        const out = frame.ways_out.find(({ cause }) => cause === name);
        const words =
          near && out ? `${title}: ${wayOutText(out, spoken(joints[out.axis]?.name ?? ''), names)}` : title;
        setText(label, words);
        setAttribute(label, 'title', words);
        setText(value, fixed(distance, 2, false));
        setClass(row, 'caution', near);
      });
    },
  };
}
